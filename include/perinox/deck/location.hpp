#pragma once
#include <string>

namespace perinox::deck {

/// A place in an input file. Lines and columns count from 1; line 0 means the whole file.
struct Location {
  std::string file;
  int line = 0;
  int column = 0;

  /// `file:line:column`, or `file` alone where the line is unknown.
  std::string text() const;
};

/// The text `<where>: <sentence>`, or the sentence alone if the place is unknown.
std::string placed(const Location& where, const std::string& sentence);

/// Throws InputError with placed(where, sentence).
[[noreturn]] void refuse(const Location& where, const std::string& sentence);

}  // namespace perinox::deck
