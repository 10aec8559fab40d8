#pragma once
/// Finds what begins the lines of a YAML text's blocks, in order. Part of find_layout_mistake.
#include <optional>
#include <string>
#include <vector>

#include "layout.hpp"

namespace perinox::deck {

enum class LayoutForm { hyphen, key, text };

/// The beginning of a line of a block: a hyphen, or a key or text, which may stand behind a hyphen or alone.
struct LayoutItem {
  LayoutForm form;
  int line, column;   ///< the column from 0
  bool open = false;  ///< a hyphen, or a key without a value on its line; a block that is indented further may follow
  std::string text;   ///< the key, or the text of the line
};

/// The items of a text up to its end or to the first mistake within a line.
struct LayoutItems {
  std::vector<LayoutItem> items;
  std::optional<LayoutMistake> mistake;
};
LayoutItems read_layout_items(const std::string& yaml);

}  // namespace perinox::deck
