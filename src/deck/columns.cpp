#include "columns.hpp"

#include <algorithm>

namespace perinox::deck {

Columns::Columns(const std::string& text) {
  const std::size_t first = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  line_starts_.push_back(first);
  for (std::size_t k = first; k < text.size(); ++k) {
    if (text[k] == '\n') line_starts_.push_back(k + 1);
    if ((static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U) inner_bytes_.push_back(k);
  }
}

int Columns::of(int line, int bytes) const {
  if (inner_bytes_.empty() || line < 1 || static_cast<std::size_t>(line) > line_starts_.size()) return bytes + 1;
  const std::size_t begin = line_starts_[static_cast<std::size_t>(line) - 1];
  const auto before = [&](std::size_t place) {
    return std::lower_bound(inner_bytes_.begin(), inner_bytes_.end(), place);
  };
  return bytes + 1 - static_cast<int>(before(begin + static_cast<std::size_t>(std::max(bytes, 0))) - before(begin));
}

}  // namespace perinox::deck
