#include "perinox/output/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "perinox/core/error.hpp"

namespace perinox::output {

std::optional<std::size_t> NumberTable::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::string csv_cell(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char letter : name) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::vector<std::string> csv_cells(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"')
      cells.back() += line[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += c;
  }
  return cells;
}

NumberTable read_table(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream whole;
  whole << file.rdbuf();
  std::string text = whole.str();
  if (!file || text.find('\n') == std::string::npos) throw RunError(path + " cannot be read or is empty");
  text.erase(text.rfind('\n'));  // what follows was not written to its end
  NumberTable table;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  table.names = csv_cells(line);
  for (long number = 2; std::getline(lines, line); ++number) {
    std::vector<double> row;
    for (const std::string& cell : csv_cells(line)) {
      char* end = nullptr;
      row.push_back(std::strtod(cell.c_str(), &end));
      if (cell.empty() || *end != '\0')
        throw RunError(fmt::format("{}, line {}: '{}' is no number", path, number, cell));
    }
    if (row.size() != table.names.size())
      throw RunError(fmt::format("{}, line {}: {} cells under {} names", path, number, row.size(), table.names.size()));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace perinox::output
