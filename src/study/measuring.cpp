#include "measuring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "history_measure.hpp"
#include "nearby_fit.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/condition.hpp"
#include "perinox/deck/scalar.hpp"
#include "perinox/output/results_reader.hpp"
#include "perinox/output/table_reader.hpp"

namespace perinox::study {

namespace {
const std::vector<std::string> place_and_time{"x", "y", "z", "t"};

/// Number of columns of a field in results.h5, by its name.
int columns_of(const std::string& field) {
  if (field == "displacement" || field == "force") return 3;
  return field == "stress" || field == "strain" ? 9 : 1;
}

/// The step at `at`, or the last one.
output::ResultsReader::Step step_of(const output::ResultsReader& file, const Measure& measure,
                                    const std::string& path) {
  const auto steps = file.steps();
  if (steps.empty()) throw RunError(path + " holds no step");
  if (!measure.at) return steps.back();
  for (const auto& step : steps)
    if (same_time(step.t, *measure.at)) return step;
  throw RunError(fmt::format("{} holds no step at t = {:g}, where {} is taken", path, *measure.at, measure.name));
}

/// Slack of the comparisons in `where`, length, as a set's condition has it.
double slack_of(const output::ResultsReader& file, const std::vector<double>& place,
                const std::vector<double>& volume) {
  double largest = 0, coordinate = 0;
  for (const double one : volume) largest = std::max(largest, one);
  for (const double one : place) coordinate = std::max(coordinate, std::abs(one));
  return 1e-9 * std::pow(largest, 1.0 / file.dimension()) + 8 * std::numeric_limits<double>::epsilon() * coordinate;
}

/// What a field is compared with, at any place.
class ExactField {
 public:
  ExactField(const Measure& measure, const PlannedRun& run, const std::string& reference, int columns) {
    if (reference.empty()) {
      for (const std::string& component : components_of(columns)) {
        const auto text = measure.solution.find(component);
        compared_.push_back(text != measure.solution.end());
        formulas_.push_back(compared_.back() ? formula(text->second, run.numbers, place_and_time, measure.location)
                                             : deck::Expression());
      }
      return;
    }
    compared_.assign(places_of(columns).size(), true);
    const output::ResultsReader file(reference);
    const auto step = step_of(file, measure, reference);
    if (file.columns(step.number, measure.field) != columns)
      throw RunError(fmt::format("{} holds no field {} of {} columns", reference, measure.field, columns));
    fit_.emplace(file.reference(), file.field(step.number, measure.field), columns, file.dimension());
  }
  bool compares(std::size_t component) const { return compared_[component]; }
  /// The value of each component at a place.
  std::vector<double> at(const double* place, double t) const {
    std::vector<double> values;
    if (fit_) {
      const std::vector<double> columns = fit_->at(place);
      for (const std::size_t c : places_of(static_cast<int>(columns.size()))) values.push_back(columns[c]);
      return values;
    }
    for (const deck::Expression& one : formulas_) values.push_back(one(place[0], place[1], place[2], t));
    return values;
  }

 private:
  std::vector<bool> compared_;
  std::vector<deck::Expression> formulas_;
  std::optional<NearbyFit> fit_;
};

Values field_value(const Measure& measure, const PlannedRun& run, const std::string& folder,
                   const std::string& reference) {
  const std::string path = folder + "/results.h5";
  const output::ResultsReader file(path);
  const auto step = step_of(file, measure, path);
  const int columns = file.columns(step.number, measure.field);
  if (columns == 0) throw RunError(fmt::format("{} holds no field {}", path, measure.field));
  const std::vector<double> place = file.reference(), volume = file.volume(),
                            field = file.field(step.number, measure.field);
  const deck::Condition where(measure.where.empty()
                                  ? deck::Expression(1.0)
                                  : formula(measure.where, run.numbers, {"x", "y", "z"}, measure.location));
  const double slack = slack_of(file, place, volume);
  const ExactField exact(measure, run, reference, columns);
  const std::vector<std::size_t>& components = places_of(columns);
  double error = 0, size = 0, largest_error = 0, largest = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < file.particles(); ++i) {
    const double* x = &place[i * 3];
    const bool in = where.holds({x[0], x[1], x[2]}, slack);
    if (where.undefined())
      throw RunError(fmt::format("the condition {} of the measure {} is not a number at ({:g}, {:g}, {:g})",
                                 measure.where, measure.name, x[0], x[1], x[2]));
    if (!in) continue;
    ++taken;
    const std::vector<double> wanted = exact.at(x, step.t);
    double difference = 0, square = 0;
    for (std::size_t c = 0; c < wanted.size(); ++c) {
      if (!exact.compares(c)) continue;
      difference += std::pow(field[i * static_cast<std::size_t>(columns) + components[c]] - wanted[c], 2);
      square += wanted[c] * wanted[c];
    }
    error += volume[i] * difference;
    size += volume[i] * square;
    largest_error = std::max(largest_error, difference);
    largest = std::max(largest, square);
  }
  if (taken == 0) throw RunError(fmt::format("no particle of {} is where {} is taken", path, measure.name));
  return {{measure.error_column(), std::sqrt(size > 0 ? error / size : error)},
          {measure.name + "_largest", std::sqrt(largest > 0 ? largest_error / largest : largest_error)}};
}
}  // namespace

void check_measures(const Study& study, const PlannedRun& run, const deck::Deck& deck) {
  for (const Measure& measure : study.measures) {
    if (measure.field.empty()) {
      check_history_measure(measure, run, deck);
      continue;
    }
    std::vector<std::string> fields = deck.output.fields;
    for (const char* always : {"displacement", "force"})
      if (std::find(fields.begin(), fields.end(), always) == fields.end()) fields.emplace_back(always);
    if (std::find(fields.begin(), fields.end(), measure.field) == fields.end())
      deck::refuse(measure.location,
                   fmt::format("the runs do not write the field {}{}; the deck's output.fields says which they write",
                               measure.field, deck::did_you_mean(measure.field, fields)));
    const std::vector<std::string>& components = components_of(columns_of(measure.field));
    for (const auto& [component, text] : measure.solution) {
      if (std::find(components.begin(), components.end(), component) == components.end())
        deck::refuse(measure.location, fmt::format("{} is no component of the field {}; it has {}", component,
                                                   measure.field, deck::listing(components, "and")));
      formula(text, run.numbers, place_and_time, measure.location);
    }
    if (!measure.where.empty()) formula(measure.where, run.numbers, {"x", "y", "z"}, measure.location);
  }
}

Values counts_of(const std::string& folder) {
  const output::ResultsReader file(folder + "/results.h5");
  const auto particles = static_cast<double>(file.particles());
  Values values{{"particles", particles}, {"unknowns", particles * file.dimension()}};
  const output::NumberTable table = output::read_table(folder + "/history.csv");
  const std::size_t step = table.column("step").value();
  values["steps"] = static_cast<double>(
      std::count_if(table.rows.begin(), table.rows.end(), [&](const auto& row) { return row[step] > 0; }));
  const std::pair<const char*, const char*> sums[] = {{"newton_iterations", "newton_iterations"},
                                                      {"linear_iterations", "linear_iterations"},
                                                      {"solve_seconds", "seconds"}};
  for (const auto& [name, column] : sums) {
    double& sum = values[name];
    for (const auto& row : table.rows) sum += row[table.column(column).value()];
  }
  return values;
}

Values measured(const Measure& measure, const PlannedRun& run, const std::string& folder,
                const std::string& reference) {
  Values values =
      measure.field.empty() ? history_value(measure, run, folder) : field_value(measure, run, folder, reference);
  for (const auto& [name, value] : values)
    if (!std::isfinite(value)) throw RunError(fmt::format("{} of the run in {} is {}", name, folder, value));
  return values;
}

}  // namespace perinox::study
