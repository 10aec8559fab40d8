#pragma once
/// Reads the characters of a YAML text one after the other, with their places. Flow maps, flow lists and quotes are
/// passed as a whole. Part of find_layout_mistake.
#include <optional>
#include <string>
#include <vector>

#include "layout.hpp"

namespace perinox::deck {

class LayoutText {
 public:
  explicit LayoutText(const std::string& yaml);

  bool at_end() const { return at_ >= text_.size(); }
  bool at_line_end() const { return at_end() || text_[at_] == '\n' || (text_[at_] == '\r' && peek(1) == '\n'); }
  /// The character `ahead` of the current position; '\0' behind the end.
  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::size_t position() const { return at_; }
  int line() const { return line_; }
  /// Column of the current position, from 0.
  int column() const { return static_cast<int>(at_ - line_start_); }
  void advance(std::size_t count = 1) { at_ += count; }
  void skip_blanks();
  /// Skips blanks, and a comment if there is one, because both may end a line.
  void skip_to_line_end_if_empty();
  void next_line();
  /// Number of blanks at the head of the next line. A line of blanks counts as indented far, and -1 stands for the
  /// text's end.
  int indentation_of_next_line() const;
  /// The rest of the line from here, without its end.
  std::string rest_of_line() const;
  std::string between(std::size_t begin, std::size_t end) const { return text_.substr(begin, end - begin); }
  /// True at a colon that ends a key: one before a blank or the end of the line.
  bool at_colon() const;
  /// True if the rest of this line starts as an entry of a block does: `key: ...` or `- ...`.
  bool starts_block_entry() const;

  /// Moves past the quoted text that begins here. A text that runs over the lines of other keys was never closed.
  void pass_quotes();
  /// Moves past the flow map or list that begins here. A key at or before `least_column` on a later line belongs to the
  /// block around, and shows that the flow was never closed.
  void pass_flow(int least_column);

  /// Notes a mistake at a place of the current line, if there is none yet. Nothing is read after it.
  void mistake(int line, int column, std::string sentence, bool hidden = false);
  void mistake_here(std::string sentence, bool hidden = false) {
    mistake(line_, column(), std::move(sentence), hidden);
  }
  const std::optional<LayoutMistake>& found() const { return found_; }
  /// Notes a character outside of quotes that only looks like a blank, a quote or a minus.
  void watch_character();

 private:
  struct Open {
    char bracket;
    int line, column;
    bool has_colon = false;  ///< in the current entry
    bool complete = false;   ///< a bracket or a quote has closed in the current entry, so a comma must follow
  };
  /// Passes one token of a flow. Returns false if the flow is over or wrong.
  bool pass_flow_token(std::vector<Open>& open, int least_column);
  bool close_flow(std::vector<Open>& open);
  void pass_flow_word(Open& inner);
  void second_colon(std::size_t begin, std::size_t word);

  const std::string& text_;
  std::size_t at_ = 0, line_start_ = 0;
  int line_ = 1;
  std::optional<LayoutMistake> found_;
};

}  // namespace perinox::deck
