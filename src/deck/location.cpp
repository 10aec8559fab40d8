#include "perinox/deck/location.hpp"

#include <fmt/format.h>

#include "perinox/core/error.hpp"

namespace perinox::deck {

namespace {

/// Makes one line of a text. What a deck or a file says may hold anything, but a message is one line of limited length
/// that a terminal can show.
std::string as_one_line(const std::string& text) {
  constexpr std::size_t longest = 2000;
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else {
      line += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
  }
  if (line.size() <= longest) return line;
  // The end of a message is kept because it says what to do.
  return line.substr(0, longest / 2) + " ... " + line.substr(line.size() - longest / 2);
}

}  // namespace

std::string Location::text() const {
  if (line <= 0) return file;
  return fmt::format("{}:{}:{}", file, line, column);
}

std::string placed(const Location& where, const std::string& sentence) {
  const std::string place = where.text();
  return as_one_line(place.empty() ? sentence : place + ": " + sentence);
}

void refuse(const Location& where, const std::string& sentence) { throw InputError(placed(where, sentence)); }

}  // namespace perinox::deck
