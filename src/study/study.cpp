#include "perinox/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "perinox/deck/declared.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::study {

namespace {
namespace fs = std::filesystem;
using deck::refuse;
using deck::Value;

std::string text_of(const Value& map, const std::string& key) { return map.has(key) ? map.at(key).text() : ""; }

std::vector<Setting> settings_of(const Value& map) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : map.entries()) settings.push_back({value.location(), key, value.text()});
  return settings;
}

std::string last_word(const std::string& path) { return path.substr(path.rfind('.') + 1); }

SweepPoint point_of(const std::string& label, std::vector<Setting> set) {
  return {label, deck::parse_number(label), std::move(set)};
}

Sweep sweep_of(const Value& value) {
  Sweep sweep;
  sweep.location = value.location();
  if (value.has("points")) {
    if (!value.has("name")) refuse(value.location(), "a sweep with points needs the key name: what tables call it");
    for (const Value& point : value.at("points").items())
      sweep.points.push_back(point_of(point.at("label").text(), settings_of(point.at("set"))));
  } else {
    if (!value.has("values")) refuse(value.location(), "a sweep with a key needs values: what it is set to");
    if (!value.has("key"))
      refuse(value.location(), "a sweep with values needs a key: the dotted path of what they set, or ranks");
    for (const Value& item : value.at("values").items())
      sweep.points.push_back(point_of(item.text(), {{item.location(), value.at("key").text(), item.text()}}));
  }
  sweep.name = value.has("name") ? value.at("name").text() : last_word(value.at("key").text());
  std::set<std::string> labels;
  for (const SweepPoint& point : sweep.points)
    if (!labels.insert(point.label).second)
      refuse(sweep.location,
             fmt::format("the sweep {} has two points with the label {}; rename one", sweep.name, point.label));
  return sweep;
}

void read_take(const Value& value, Measure& measure) {
  const std::string take = value.at("take").text();
  measure.take = static_cast<Take>(std::find(take_words().begin(), take_words().end(), take) - take_words().begin());
  if (measure.take != Take::end && measure.at)
    refuse(value.at("at").location(),
           fmt::format("at is one row and take: {} chooses among all; remove one of them from the measure {}", take,
                       measure.name));
  if (measure.at && !measure.where.empty())
    refuse(value.at("where").location(),
           fmt::format("at is one row already; remove at or where from the measure {}", measure.name));
  const bool has_argument = measure.take == Take::argmax || measure.take == Take::argmin;
  if (value.has("argument") && !has_argument)
    refuse(value.at("argument").location(),
           fmt::format("argument goes with take: argmax and argmin only; remove it from the measure {}", measure.name));
  if (has_argument) measure.argument = value.has("argument") ? value.at("argument").text() : "t";
}

Measure measure_of(const Value& value, const fs::path& folder) {
  Measure measure;
  measure.location = value.location();
  measure.name = value.at("name").text();
  measure.history = text_of(value, "history");
  measure.field = text_of(value, "field");
  measure.exact = text_of(value, "exact");
  measure.reference = text_of(value, "reference");
  measure.where = text_of(value, "where");
  const auto only = [&](const char* key, const char* other) {
    if (value.has(key))
      refuse(value.at(key).location(),
             fmt::format("{} does not go with {}; remove one of them from the measure {}", key, other, measure.name));
  };
  if (const std::string at = text_of(value, "at"); !at.empty() && at != "end") {
    measure.at = deck::parse_number(at);
    if (!measure.at)
      refuse(value.at("at").location(), fmt::format("at must be a number or end, but '{}' was found", at));
  }
  if (!measure.history.empty()) {
    for (const char* key : {"solution", "reference"}) only(key, "history");
    read_take(value, measure);
    return measure;
  }
  for (const char* key : {"exact", "argument"}) only(key, "field");
  if (value.at("take").given()) only("take", "field");
  if (value.has("solution")) {
    only("reference", "solution");
    for (const auto& [component, text] : value.at("solution").entries()) measure.solution[component] = text.text();
    if (measure.solution.empty())
      refuse(value.at("solution").location(), "a solution needs a formula for at least one component");
  } else if (measure.reference.empty()) {
    refuse(
        value.location(),
        fmt::format("the measure {} of a field needs what it is compared with: solution or reference", measure.name));
  } else if (measure.reference != "finest") {
    const fs::path path = (folder / measure.reference).lexically_normal();
    if (!fs::is_regular_file(path))
      refuse(value.at("reference").location(),
             fmt::format("there is no file {}; reference is finest or a results.h5, relative to the study's folder",
                         path.string()));
    measure.reference = path.string();
  }
  return measure;
}

/// Checks that names of columns are unique and that names of sweeps are none that a formula has itself.
void check_names(const Study& study) {
  std::set<std::string> names{"run", "status", "reason"};
  for (const std::string& cost : cost_columns()) names.insert(cost);
  names.erase("ranks");
  const auto take = [&](const std::string& name, const deck::Location& where) {
    if (!names.insert(name).second)
      refuse(where, fmt::format("there are two columns {}; give this one another name", name));
  };
  for (const Sweep& sweep : study.sweep) {
    for (const char* own : {"x", "y", "z", "t", "pi"})
      if (sweep.name == own)
        refuse(sweep.location, fmt::format("{} means something else in formulas; give the sweep another name", own));
    take(sweep.name, sweep.location);
  }
  for (const Measure& measure : study.measures)
    for (const std::string& column : measure.columns()) take(column, measure.location);
  for (const PlotRequest& plot : study.plots)
    for (const std::string& name : {plot.x, plot.y}) {
      if (names.count(name) > 0 && name != "run" && name != "status" && name != "reason") continue;
      const std::vector<std::string> known(names.begin(), names.end());
      refuse(plot.location, fmt::format("{} is no column of the table{}", name, deck::did_you_mean(name, known)));
    }
}

Study study_of(const Value& value, const std::string& file) {
  Study study;
  study.file = file;
  const fs::path folder = fs::path(file).parent_path();
  study.title = value.has("title") ? value.at("title").text() : fs::path(file).stem().string();
  study.deck = (folder / value.at("deck").text()).lexically_normal().string();
  if (!fs::is_regular_file(study.deck))
    refuse(value.at("deck").location(),
           fmt::format("there is no deck {}; its name starts at the study's folder", study.deck));
  study.kind = value.at("kind").text() == "newton" ? Kind::newton : Kind::convergence;
  if (value.has("newton_step")) {
    if (study.kind != Kind::newton)
      refuse(value.at("newton_step").location(), "newton_step goes with kind: newton only; remove it");
    study.newton_step = static_cast<int>(value.at("newton_step").integer());
  }
  study.repeat = static_cast<int>(value.at("repeat").integer());
  study.set = settings_of(value.at("set"));
  for (const Value& item : value.at("sweep").items()) study.sweep.push_back(sweep_of(item));
  for (const Value& item : value.at("measures").items()) study.measures.push_back(measure_of(item, folder));
  for (const Value& item : value.at("plots").items())
    study.plots.push_back({item.location(), item.at("x").text(), item.at("y").text()});
  if (study.kind == Kind::convergence && study.measures.empty())
    refuse(value.location(), "a study of kind convergence needs measures: what is taken from each run");
  check_names(study);
  return study;
}
}  // namespace

bool Sweep::numeric() const {
  return std::all_of(points.begin(), points.end(), [](const SweepPoint& point) { return point.number.has_value(); });
}

std::vector<std::string> Measure::columns() const {
  if (!field.empty()) return {error_column(), name + "_largest"};
  if (exact.empty()) return {name};
  return {error_column(), name};
}

const std::vector<std::string>& components_of(int columns) {
  static const std::vector<std::string> scalar{"value"}, vector{"x", "y", "z"},
      tensor{"xx", "xy", "xz", "yy", "yz", "zz"};
  return columns == 1 ? scalar : columns == 3 ? vector : tensor;
}

const std::vector<std::size_t>& places_of(int columns) {
  static const std::vector<std::size_t> scalar{0}, vector{0, 1, 2}, tensor{0, 1, 2, 4, 5, 8};
  return columns == 1 ? scalar : columns == 3 ? vector : tensor;
}

const std::vector<std::string>& take_words() {
  static const std::vector<std::string> words{"end", "first", "last", "max", "argmax", "min", "argmin"};
  return words;
}

const std::vector<std::string>& cost_columns() {
  static const std::vector<std::string> names{"ranks",        "particles",         "unknowns",          "bonds",
                                              "steps",        "newton_iterations", "linear_iterations", "cpu_seconds",
                                              "wall_seconds", "solve_seconds",     "peak_megabytes"};
  return names;
}

Study read(const std::string& file) { return study_of(deck::read_declared(file, declare_study(), "study"), file); }

Study read_text(const std::string& yaml, const std::string& file) {
  return study_of(deck::read_declared_text(yaml, file, declare_study(), "study"), file);
}

}  // namespace perinox::study
