#include "history_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perinox/core/error.hpp"
#include "perinox/deck/condition.hpp"
#include "perinox/output/table_reader.hpp"
#include "perinox/output/tables.hpp"

namespace perinox::study {

namespace {
/// One row of history.csv by the names of its columns, and the numbers of the sweeps.
Numbers numbers_of(const output::NumberTable& table, const std::vector<double>& row, const PlannedRun& run) {
  Numbers numbers = run.numbers;
  for (std::size_t c = 0; c < row.size(); ++c) numbers[table.names[c]] = row[c];
  return numbers;
}

double value_of(const std::string& text, const Numbers& numbers, const Measure& measure) {
  return formula(text, numbers, {}, measure.location)(0, 0, 0, 0);
}

bool extreme(Take take) { return take != Take::end && take != Take::first && take != Take::last; }

/// The formula's value in a row that is compared with others. A value that is no number would hide the rest.
double compared_value(const Measure& measure, const Numbers& numbers) {
  const double value = value_of(measure.history, numbers, measure);
  if (std::isfinite(value)) return value;
  throw RunError(fmt::format(
      "the measure {} is {} in step {:.0f}, t = {:g}; leave rows out in which its formula has no value, with "
      "where: \"step > {:.0f}\" for instance",
      measure.name, value, numbers.at("step"), numbers.at("t"), numbers.at("step")));
}

bool holds_in(const Measure& measure, const Numbers& numbers) {
  const deck::Condition where(formula(measure.where, numbers, {}, measure.location));
  const bool in = where.holds({0, 0, 0}, 0);
  if (!where.undefined()) return in;
  throw RunError(
      fmt::format("the condition {} of the measure {} is not a number in step {:.0f}, t = {:g}; ask first for "
                  "what makes it one",
                  measure.where, measure.name, numbers.at("step"), numbers.at("t")));
}

/// The rows that the measure looks at, in their order.
std::vector<Numbers> rows_of(const Measure& measure, const PlannedRun& run, const std::string& path) {
  const output::NumberTable table = output::read_table(path);
  std::vector<Numbers> rows;
  for (const std::vector<double>& row : table.rows) {
    Numbers numbers = numbers_of(table, row, run);
    if (measure.at && !same_time(numbers.at("t"), *measure.at)) continue;
    if (!measure.where.empty() && !holds_in(measure, numbers)) continue;
    rows.push_back(std::move(numbers));
  }
  if (!rows.empty()) return rows;
  const std::string which = measure.at               ? fmt::format(" at t = {:g}", *measure.at)
                            : !measure.where.empty() ? fmt::format(" where {}", measure.where)
                                                     : "";
  throw RunError(fmt::format("{} has no row{} for {}", path, which, measure.name));
}

const Numbers& chosen(const Measure& measure, const std::vector<Numbers>& rows) {
  if (measure.take == Take::first) return rows.front();
  if (!extreme(measure.take)) return rows.back();
  const double sign = measure.take == Take::min || measure.take == Take::argmin ? -1 : 1;
  std::size_t best = 0;
  double most = sign * compared_value(measure, rows[0]);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double value = sign * compared_value(measure, rows[k]);
    if (!(value > most)) continue;
    most = value;
    best = k;
  }
  return rows[best];
}
}  // namespace

bool same_time(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

void check_history_measure(const Measure& measure, const PlannedRun& run, const deck::Deck& deck) {
  Numbers numbers = run.numbers;
  for (const std::string& name : output::history_columns(deck)) numbers[name] = 1;
  for (const std::string& text : {measure.history, measure.argument, measure.where})
    if (!text.empty()) formula(text, numbers, {}, measure.location);
  if (!measure.exact.empty()) formula(measure.exact, run.numbers, {"t"}, measure.location);
}

Values history_value(const Measure& measure, const PlannedRun& run, const std::string& folder) {
  const std::vector<Numbers> rows = rows_of(measure, run, folder + "/history.csv");
  const Numbers& row = chosen(measure, rows);
  const double value = value_of(measure.argument.empty() ? measure.history : measure.argument, row, measure);
  Values values{{measure.name, value}};
  if (measure.exact.empty()) return values;
  const double exact = formula(measure.exact, run.numbers, {"t"}, measure.location)(0, 0, 0, row.at("t"));
  values[measure.error_column()] = exact != 0 ? (value - exact) / std::abs(exact) : value - exact;
  return values;
}

}  // namespace perinox::study
