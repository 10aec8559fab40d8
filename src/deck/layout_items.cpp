#include "layout_items.hpp"

#include <fmt/format.h>

#include <cctype>

#include "layout_text.hpp"

namespace perinox::deck {
namespace {

class ItemReader {
 public:
  explicit ItemReader(const std::string& yaml) : text_(yaml) { read(); }

  LayoutItems found() const { return {items_, text_.found()}; }

 private:
  void read() {
    for (; !text_.at_end() && !text_.found(); text_.next_line()) {
      while (text_.peek() == ' ') text_.advance();
      if (text_.peek() == '\t') {
        text_.skip_blanks();
        if (!text_.at_line_end() && text_.peek() != '#')
          text_.mistake(text_.line(), 0, "a tab cannot indent a line in YAML; use blanks");
      }
      const bool marker = text_.column() == 0 && (text_.rest_of_line() == "---" || text_.rest_of_line() == "...");
      if (marker || text_.peek() == '%') continue;
      text_.skip_to_line_end_if_empty();
      if (!text_.at_line_end() && !text_.found()) read_line();
      if (text_.at_end()) return;
    }
  }

  void read_line() {
    while (text_.peek() == '-' && (text_.peek(1) == ' ' || text_.peek(1) == '\t' || is_end(text_.peek(1)))) {
      items_.push_back({LayoutForm::hyphen, text_.line(), text_.column(), true, "-"});
      text_.advance();
      text_.skip_to_line_end_if_empty();
      if (text_.at_line_end()) return;
    }
    refuse_joined_hyphen();
    skip_properties();
    text_.watch_character();
    if (!text_.found()) read_content();
  }

  static bool is_end(char c) { return c == '\n' || c == '\r' || c == '\0'; }

  /// Refuses `-name: block`, which YAML takes for a key that begins with a hyphen.
  void refuse_joined_hyphen() {
    const char next = text_.peek(1);
    if (text_.peek() != '-' || !(std::isalpha(static_cast<unsigned char>(next)) || next == '{' || next == '[')) return;
    const std::string rest = text_.rest_of_line();
    if (next == '{' || next == '[' || rest.find(": ") != std::string::npos || rest.back() == ':')
      text_.mistake_here("a blank is missing behind the hyphen of this list entry; write - and a blank");
  }

  /// Skips anchors and tags before a value.
  void skip_properties() {
    while (text_.peek() == '&' || text_.peek() == '!') {
      while (!text_.at_line_end() && text_.peek() != ' ') text_.advance();
      text_.skip_to_line_end_if_empty();
    }
  }

  void read_content() {
    const int line = text_.line(), column = text_.column();
    const std::size_t begin = text_.position();
    const std::string whole = text_.rest_of_line();
    const char first = text_.peek();
    if (first == '"' || first == '\'') {
      text_.pass_quotes();
    } else if (first == '[' || first == '{') {
      text_.pass_flow(column);
    } else {
      while (!text_.at_line_end() && !text_.at_colon() && !(text_.peek() == ' ' && text_.peek(1) == '#')) {
        text_.watch_character();
        text_.advance();
      }
    }
    if (text_.found()) return;
    if (!text_.at_colon()) {
      items_.push_back({LayoutForm::text, line, column, false, whole});
      return pass_end(first);
    }
    items_.push_back({LayoutForm::key, line, column, false, text_.between(begin, text_.position())});
    text_.advance();
    text_.skip_to_line_end_if_empty();
    skip_properties();
    items_.back().open = text_.at_line_end();
    if (!items_.back().open) read_value(column);
  }

  void read_value(int column) {
    const char first = text_.peek();
    if (first == '|' || first == '>') return pass_block_text(column);
    if (first == '"' || first == '\'') {
      text_.pass_quotes();
      return pass_end(first);
    }
    if (first == '[' || first == '{') {
      text_.pass_flow(column);
      return pass_end(first);
    }
    const int start = text_.column();
    const bool opened = text_.rest_of_line().find('{') != std::string::npos;
    const bool closes = text_.rest_of_line().find('}') != std::string::npos;
    for (; !text_.at_line_end() && !(text_.peek() == ' ' && text_.peek(1) == '#'); text_.advance()) {
      text_.watch_character();
      if (!text_.at_colon()) continue;
      if (closes && !opened)
        return text_.mistake(text_.line(), start, "a { is missing here: a } follows that closes none");
      return text_.mistake_here(
          "a second colon on this line; put each key on a line of its own, or quotes around a text with a colon");
    }
  }

  /// Checks that nothing stands behind a value in quotes or brackets.
  void pass_end(char first) {
    if (text_.found() || (first != '"' && first != '\'' && first != '[' && first != '{')) return;
    text_.skip_to_line_end_if_empty();
    if (text_.at_line_end()) return;
    const char c = text_.peek();
    if (c == ']' || c == '}')
      text_.mistake_here(fmt::format("this {} closes nothing that is open; take it out", c));
    else if (first == '"' || first == '\'')
      text_.mistake_here("text follows the closing quote; put the whole value into the quotes");
    else if (c == ',')
      text_.mistake_here("a comma follows the closing bracket, but this list or map is not in brackets; take it out");
    else
      text_.mistake_here("text follows the closing bracket; take it out, or put the whole value into quotes");
  }

  /// Passes a text behind | or >: all lines that are indented further than its key.
  void pass_block_text(int column) {
    while (text_.indentation_of_next_line() > column) text_.next_line();
    while (!text_.at_line_end()) text_.advance();
  }

  LayoutText text_;
  std::vector<LayoutItem> items_;
};

}  // namespace

LayoutItems read_layout_items(const std::string& yaml) { return ItemReader(yaml).found(); }

}  // namespace perinox::deck
