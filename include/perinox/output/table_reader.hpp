#pragma once
#include <optional>
#include <string>
#include <vector>

namespace perinox::output {

/// A table of numbers under a line of names, such as history.csv or convergence.csv read back.
struct NumberTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  /// Position of a column; absent if there is none of this name.
  std::optional<std::size_t> column(const std::string& name) const;
};

/// Reads a table. A last line that was not written to its end is left out, because a run may have been killed while
/// writing it. Throws RunError if the file cannot be read or a cell of another line is no number.
NumberTable read_table(const std::string& path);

/// A name as a CSV cell (RFC 4180): in quotes if it holds a comma, a quote or a line end.
std::string csv_cell(const std::string& name);
/// The cells of one line of CSV, without their quotes.
std::vector<std::string> csv_cells(const std::string& line);

}  // namespace perinox::output
