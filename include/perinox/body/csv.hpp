#pragma once
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::body {

/// The columns that a kind of CSV file has. Their order in the file is free.
struct CsvColumns {
  std::string kind;                   ///< names the file in messages, as in "a point cloud"
  std::vector<std::string> required;  ///< names, exactly as in the header
  std::vector<std::string> optional;
};

/// A file of numbers under a header of column names, separated by commas. Lines that are blank or begin with # are
/// skipped, and so is a byte order mark. Lines may end in CR LF. Every value is finite.
class CsvTable {
 public:
  /// Reads the whole file. Does not communicate. Throws InputError at `asked_at` if the file cannot be read, and at
  /// `file:line:column` for an unknown, repeated or missing column name, for a row that is too short or too long, and
  /// for anything that is not a finite number.
  CsvTable(const std::string& path, const deck::Location& asked_at, const CsvColumns& columns);
  /// Makes a table from text. `file` is only named in messages.
  static CsvTable from_text(std::string text, const std::string& file, const CsvColumns& columns);

  std::size_t rows() const { return start_.size(); }
  bool has(const std::string& name) const { return index(name) < width_; }
  /// Position of a column in the rows. It should be looked up once, outside of loops.
  std::size_t column(const std::string& name) const;
  double value(std::size_t row, std::size_t column) const { return values_[row * width_ + column]; }
  /// Line of a row in the file, counted from 1.
  long long line(std::size_t row) const { return line_[row]; }
  /// Place of a value in the file, for messages.
  deck::Location where(std::size_t row, std::size_t column) const;

 private:
  CsvTable() = default;
  std::size_t index(const std::string& name) const;
  void parse(const CsvColumns& columns);
  void read_header(const char* begin, const char* end, const CsvColumns& columns);
  void read_row(const char* begin, const char* end);
  [[noreturn]] void refuse_at(const char* place, const std::string& sentence) const;

  std::string file_;
  std::string text_;
  std::size_t width_ = 0;
  std::vector<std::string> names_;
  std::vector<double> values_;      ///< [rows][width]
  std::vector<std::size_t> start_;  ///< [rows] offset of the row's first character in the text
  std::vector<long long> line_;     ///< [rows]
  long long line_number_ = 0;       ///< number of the line being read
  const char* line_start_ = nullptr;
};

}  // namespace perinox::body
