#pragma once
/// Finds where the layout of a YAML text is wrong. A YAML parser notices a slip of indentation, a missing colon or an
/// open bracket only where it cannot go on, which may be lines later; this code finds the slip itself. It reads the
/// text by itself, once, and is used only after the text has been refused, so it never refuses a text that a parser
/// takes.
#include <cstddef>
#include <optional>
#include <string>

namespace perinox::deck {

struct LayoutMistake {
  int line = 0, column = 0;  ///< from 1
  std::string sentence;      ///< what is wrong at that place, and what to do
  /// True for a slip that can leave the text readable with another meaning: quotes that swallow the rest of the text,
  /// or a character that only looks like a blank or a quote.
  bool hidden = false;
};

/// The first slip in the text, from its top. There is none if the layout is that of block maps and lists, flow maps and
/// lists, quotes, comments and block texts as decks have them. The cost grows with the length of the text.
std::optional<LayoutMistake> find_layout_mistake(const std::string& yaml);

}  // namespace perinox::deck
