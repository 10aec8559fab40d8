#pragma once
/// Reads the tables of tests/data/reference: comment lines with #, a header, rows of numbers.
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace perinox::test {

class ReferenceTable {
 public:
  explicit ReferenceTable(const std::string& name) {
    std::ifstream file(std::string(PERINOX_SOURCE_DIR) + "/tests/data/reference/" + name + ".csv");
    if (!file) throw std::runtime_error("there is no reference table " + name);
    std::string line;
    while (std::getline(file, line)) {
      if (line.empty() || line[0] == '#') continue;
      std::istringstream cells(line);
      std::string cell;
      if (columns_.empty()) {
        while (std::getline(cells, cell, ',')) columns_.push_back(cell);
        continue;
      }
      rows_.emplace_back();
      while (std::getline(cells, cell, ',')) rows_.back().push_back(std::stod(cell));
      if (rows_.back().size() != columns_.size())
        throw std::runtime_error("a row of " + name + " is too short or too long");
    }
  }

  std::size_t rows() const { return rows_.size(); }
  double at(std::size_t row, const std::string& column) const { return rows_.at(row).at(index(column)); }
  /// The vectors x, y, z in three columns of the rows [first, first + count), one after the other.
  std::vector<double> vectors(const std::string& x, const std::string& y, const std::string& z, std::size_t first,
                              std::size_t count) const {
    std::vector<double> values;
    for (std::size_t row = first; row < first + count; ++row)
      for (const std::string& column : {x, y, z}) values.push_back(at(row, column));
    return values;
  }
  std::vector<double> column(const std::string& name, std::size_t first, std::size_t count) const {
    std::vector<double> values;
    for (std::size_t row = first; row < first + count; ++row) values.push_back(at(row, name));
    return values;
  }

 private:
  std::size_t index(const std::string& column) const {
    for (std::size_t c = 0; c < columns_.size(); ++c)
      if (columns_[c] == column) return c;
    throw std::runtime_error("the reference table has no column " + column);
  }
  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace perinox::test
