#include "layout_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace perinox::deck {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_bracket(char c) { return c == '[' || c == ']' || c == '{' || c == '}'; }
char closing(char bracket) { return bracket == '[' ? ']' : '}'; }
const char* kind_of(char bracket) { return bracket == '[' ? "list" : "map"; }

/// A character that word processors and web pages put in the place of a plain one.
struct LookAlike {
  const char* bytes;
  const char* sentence;
};
constexpr std::array<LookAlike, 9> look_alikes{{
    {"\xC2\xA0", "this is a no-break space, which is no blank in YAML; type a blank in its place"},
    {"\xE2\x80\xAF", "this is a no-break space, which is no blank in YAML; type a blank in its place"},
    {"\xE3\x80\x80", "this is a wide space, which is no blank in YAML; type a blank in its place"},
    {"\xE2\x80\x8B", "there is an invisible character (zero-width space) here; take it out"},
    {"\xE2\x80\x9C", "this is a typographic quotation mark; type \" in its place"},
    {"\xE2\x80\x9D", "this is a typographic quotation mark; type \" in its place"},
    {"\xE2\x80\x98", "this is a typographic quotation mark; type ' in its place"},
    {"\xE2\x80\x99", "this is a typographic quotation mark; type ' in its place"},
    {"\xE2\x88\x92", "this is a typographic minus sign; type - in its place"},
}};

}  // namespace

LayoutText::LayoutText(const std::string& yaml) : text_(yaml) {
  if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) at_ = line_start_ = 3;
}

void LayoutText::skip_blanks() {
  while (is_blank(peek())) ++at_;
}

void LayoutText::skip_to_line_end_if_empty() {
  const std::size_t before = at_;
  skip_blanks();
  const bool apart = at_ > before || at_ == line_start_ || is_blank(text_[at_ - 1]);
  if (peek() != '#' || !apart) return;
  while (!at_line_end()) ++at_;
}

void LayoutText::next_line() {
  at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
  line_start_ = at_;
  ++line_;
}

int LayoutText::indentation_of_next_line() const {
  std::size_t k = text_.find('\n', at_);
  if (k == std::string::npos || ++k == text_.size()) return -1;
  const std::size_t begin = k;
  while (k < text_.size() && text_[k] == ' ') ++k;
  const bool empty = k == text_.size() || text_[k] == '\n' || text_[k] == '\r';
  return empty ? std::numeric_limits<int>::max() : static_cast<int>(k - begin);
}

std::string LayoutText::rest_of_line() const {
  std::size_t end = std::min(text_.find('\n', at_), text_.size());
  while (end > at_ && (is_blank(text_[end - 1]) || text_[end - 1] == '\r')) --end;
  return text_.substr(at_, end - at_);
}

bool LayoutText::at_colon() const {
  if (peek() != ':') return false;
  const char next = peek(1);
  return next == '\0' || is_blank(next) || next == '\n' || next == '\r';
}

bool LayoutText::starts_block_entry() const {
  std::size_t k = at_;
  while (k < text_.size() && is_blank(text_[k])) ++k;
  const auto ends = [&](std::size_t place) {
    return place >= text_.size() || is_blank(text_[place]) || text_[place] == '\n' || text_[place] == '\r';
  };
  if (k < text_.size() && text_[k] == '-' && ends(k + 1)) return true;
  const std::size_t begin = k;
  const auto of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  while (k < text_.size() && of_word(text_[k])) ++k;
  return k > begin && k < text_.size() && text_[k] == ':' && ends(k + 1);
}

void LayoutText::mistake(int line, int column, std::string sentence, bool hidden) {
  if (!found_) found_ = LayoutMistake{line, column + 1, std::move(sentence), hidden};
}

void LayoutText::watch_character() {
  if (static_cast<unsigned char>(peek()) < 0x80) return;
  for (const LookAlike& one : look_alikes)
    if (text_.compare(at_, std::char_traits<char>::length(one.bytes), one.bytes) == 0)
      return mistake_here(one.sentence, true);
}

void LayoutText::pass_quotes() {
  const char quote = peek();
  const int line = line_, start = column();
  const auto never_closed = [&](bool hidden) {
    mistake(line, start, fmt::format("the text in quotes that begins here is not closed; write the closing {}", quote),
            hidden);
  };
  for (++at_; !at_end();) {
    const char c = text_[at_];
    if (c == '\n') {
      next_line();
      if (starts_block_entry()) never_closed(false);
    } else if (quote == '"' && c == '\\') {
      at_ += text_.compare(at_ + 1, 1, "\n") == 0 ? 1 : 2;
    } else if (c == quote && quote == '\'' && peek(1) == '\'') {
      at_ += 2;
    } else if (c == quote) {
      ++at_;
      return;
    } else {
      ++at_;
    }
  }
  at_ = text_.size();
  never_closed(true);
  // Without its closing quote a text may swallow all the rest, and no parser objects.
  if (found_->line == line && found_->column == start + 1) found_->hidden = true;
}

void LayoutText::pass_flow(int least_column) {
  std::vector<Open> open;
  do {
    if (!pass_flow_token(open, least_column)) return;
  } while (!open.empty());
}

bool LayoutText::pass_flow_token(std::vector<Open>& open, int least_column) {
  if (!open.empty()) skip_to_line_end_if_empty();
  const auto not_closed = [&] {
    const Open& inner = open.back();
    mistake(inner.line, inner.column,
            fmt::format("the {} opened with {} here is not closed; write the closing {}", kind_of(inner.bracket),
                        inner.bracket, closing(inner.bracket)));
    return false;
  };
  if (at_end()) return not_closed();
  if (at_line_end()) {
    next_line();
    if (at_end()) return not_closed();
    std::size_t indentation = 0;
    while (is_blank(peek(indentation))) ++indentation;
    return static_cast<int>(indentation) <= least_column && starts_block_entry() ? not_closed() : true;
  }
  const char c = peek();
  if (c == ']' || c == '}') return close_flow(open);
  const bool closes_key = c == ':' && (at_colon() || open.back().complete || is_bracket(peek(1)) || peek(1) == ',');
  if (!open.empty() && (c == ',' || closes_key)) {
    open.back().has_colon = c == ':';
    open.back().complete = false;
    ++at_;
    return true;
  }
  if (!open.empty() && open.back().complete) {
    mistake_here("a comma is missing before this");
    return false;
  }
  if (c == '[' || c == '{') {
    open.push_back({c, line_, column()});
    ++at_;
  } else if (c == '"' || c == '\'') {
    open.back().complete = true;
    pass_quotes();
  } else {
    pass_flow_word(open.back());
  }
  return !found_;
}

bool LayoutText::close_flow(std::vector<Open>& open) {
  const Open inner = open.back();
  if (closing(inner.bracket) != peek()) {
    mistake(inner.line, inner.column,
            fmt::format("the {} opened with {} here is not closed before the {} of line {}, column {}; write {} first",
                        kind_of(inner.bracket), inner.bracket, peek(), line_, column() + 1, closing(inner.bracket)));
    return false;
  }
  ++at_;
  open.pop_back();
  if (!open.empty()) open.back().complete = true;
  return true;
}

/// Passes plain text up to what ends it. A second colon in it means that a comma was left out before the word that the
/// colon ends, or a bracket before the first word. An open parenthesis at its end means that a comma has cut a formula
/// in two.
void LayoutText::pass_flow_word(Open& inner) {
  const std::size_t begin = at_;
  const int start = column();
  std::size_t word = at_;
  int parentheses = 0;
  for (; !at_line_end() && peek() != ',' && !is_bracket(peek()); ++at_) {
    if (is_blank(peek())) {
      if (peek(1) == '#') break;
      word = at_ + 1;
    }
    parentheses += peek() == '(' ? 1 : peek() == ')' ? -1 : 0;
    watch_character();
    if (!at_colon()) continue;
    if (inner.bracket == '{' && inner.has_colon) second_colon(begin, word);
    return;
  }
  if (parentheses > 0 && peek() == ',')
    mistake(
        line_, start,
        "to YAML this value ends at the comma in its parentheses; put a formula in quotes, and the numbers of a list "
        "in brackets, as [0, 0, 0]",
        true);
}

void LayoutText::second_colon(std::size_t begin, std::size_t word) {
  const int column_of_word = static_cast<int>(word - line_start_);
  if (word == begin)
    return mistake(line_, column_of_word, "a { is missing here: a key begins where the value of another is expected");
  const std::size_t before = text_.find_last_not_of(' ', word - 1);
  const bool semicolon = before != std::string::npos && text_[before] == ';';
  mistake(line_, column_of_word,
          semicolon ? "a comma separates the entries of a map, not a semicolon; write a comma before this"
                    : "a comma is missing before this");
}

}  // namespace perinox::deck
