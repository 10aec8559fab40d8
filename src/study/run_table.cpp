#include "run_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "perinox/output/table_reader.hpp"

namespace perinox::study {

double Row::value(const std::string& column) const {
  if (const auto found = values.find(column); found != values.end()) return found->second;
  if (const auto found = run.numbers.find(column); found != run.numbers.end()) return found->second;
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> value_columns(const Study& study) {
  std::vector<std::string> columns;
  if (study.kind == Kind::newton) columns.emplace_back("newton_order");
  for (const Measure& measure : study.measures)
    for (const std::string& column : measure.columns()) columns.push_back(column);
  for (const std::string& cost : cost_columns())
    if (std::none_of(study.sweep.begin(), study.sweep.end(), [&](const Sweep& sweep) { return sweep.name == cost; }))
      columns.push_back(cost);
  return columns;
}

std::string csv_text(const Study& study, const std::vector<Row>& rows) {
  using output::csv_cell;
  std::string text = "run";
  for (const Sweep& sweep : study.sweep) text += "," + csv_cell(sweep.name);
  text += ",status,reason";
  const std::vector<std::string> columns = value_columns(study);
  for (const std::string& column : columns) text += "," + csv_cell(column);
  for (const Row& row : rows) {
    text += "\n" + row.run.name;
    for (const std::string& label : row.run.label) text += "," + csv_cell(label);
    text += fmt::format(",{},{}", row.status, csv_cell(row.reason));
    for (const std::string& column : columns) {
      const auto found = row.values.find(column);
      text += found == row.values.end() ? "," : fmt::format(",{:.17g}", found->second);
    }
  }
  return text + "\n";
}

std::string short_number(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (value == std::floor(value) && size < 1e9) return fmt::format("{:.0f}", value);
  return size >= 1e-2 && size < 1e5 ? fmt::format("{:.4g}", value) : fmt::format("{:.2e}", value);
}

std::vector<std::vector<std::string>> short_table(const Study& study, const std::vector<Row>& rows) {
  std::vector<std::string> shown;
  for (const std::string& column : value_columns(study))
    if (column != "bonds" && column != "unknowns" && column != "steps" && column != "wall_seconds" &&
        column != "solve_seconds")
      if (column != "ranks" || std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.run.ranks > 1; }))
        shown.push_back(column);
  std::vector<std::vector<std::string>> table(1);
  for (const Sweep& sweep : study.sweep) table[0].push_back(sweep.name);
  table[0].emplace_back("status");
  table[0].insert(table[0].end(), shown.begin(), shown.end());
  for (const Row& row : rows) {
    std::vector<std::string> cells = row.run.label;
    cells.push_back(std::to_string(row.status));
    for (const std::string& column : shown)
      cells.push_back(row.values.count(column) > 0 ? short_number(row.values.at(column)) : "-");
    table.push_back(std::move(cells));
  }
  return table;
}

}  // namespace perinox::study
