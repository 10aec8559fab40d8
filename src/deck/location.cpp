#include "perinox/deck/location.hpp"

#include <fmt/format.h>

#include "perinox/core/error.hpp"

namespace perinox::deck {

std::string Location::text() const {
  if (line <= 0) return file;
  return fmt::format("{}:{}:{}", file, line, column);
}

std::string placed(const Location& where, const std::string& sentence) {
  const std::string place = where.text();
  return place.empty() ? sentence : place + ": " + sentence;
}

void refuse(const Location& where, const std::string& sentence) { throw InputError(placed(where, sentence)); }

}  // namespace perinox::deck
