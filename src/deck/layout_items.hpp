#pragma once
/// What begins the lines of a YAML text's blocks, in order. Part of find_layout_mistake.
#include <optional>
#include <string>
#include <vector>

#include "layout.hpp"

namespace perinox::deck {

enum class LayoutForm { hyphen, key, text };

/// What begins a line of a block: a hyphen, and behind it or alone a key or a text.
struct LayoutItem {
  LayoutForm form;
  int line, column;   ///< the column from 0
  bool open = false;  ///< a hyphen, or a key without a value on its line: a block may follow that is indented further
  std::string text;   ///< the key, or the text of the line
};

/// The items of a text up to its end or the first mistake within a line.
struct LayoutItems {
  std::vector<LayoutItem> items;
  std::optional<LayoutMistake> mistake;
};
LayoutItems read_layout_items(const std::string& yaml);

}  // namespace perinox::deck
