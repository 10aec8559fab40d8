#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace perinox::deck {

/// Columns as an editor shows them. They count characters, where a parser counts the bytes of UTF-8.
class Columns {
 public:
  explicit Columns(const std::string& text);
  /// The column, from 1, of the character that begins `bytes` bytes into the line (counted from 1). It costs a search,
  /// and nothing in a text of ASCII.
  int of(int line, int bytes) const;
  /// Position at which each line begins. The first one begins behind a byte order mark.
  const std::vector<std::size_t>& line_starts() const { return line_starts_; }

 private:
  std::vector<std::size_t> line_starts_;
  std::vector<std::size_t> inner_bytes_;  ///< positions of all bytes that do not begin a character, rising
};

}  // namespace perinox::deck
