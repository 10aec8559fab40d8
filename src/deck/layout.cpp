#include "layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "layout_text.hpp"

namespace perinox::deck {
namespace {

enum class Form { hyphen, key, text };

/// What begins a line of a block: a hyphen, and behind it or alone a key or a text.
struct Item {
  Form form;
  int line, column;   ///< the column from 0
  bool open = false;  ///< a hyphen, or a key without a value on its line: a block may follow that is indented further
  std::string text;   ///< the key, or the text of the line
};

/// The items of a text up to its end or the first mistake within a line.
class ItemReader {
 public:
  explicit ItemReader(const std::string& yaml) : text_(yaml) { read(); }

  const std::vector<Item>& items() const { return items_; }
  const std::optional<LayoutMistake>& mistake() const { return text_.found(); }

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
      items_.push_back({Form::hyphen, text_.line(), text_.column(), true, "-"});
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

  /// `-name: block`: to YAML a key that begins with a hyphen.
  void refuse_joined_hyphen() {
    const char next = text_.peek(1);
    if (text_.peek() != '-' || !(std::isalpha(static_cast<unsigned char>(next)) || next == '{' || next == '[')) return;
    const std::string rest = text_.rest_of_line();
    if (next == '{' || next == '[' || rest.find(": ") != std::string::npos || rest.back() == ':')
      text_.mistake_here("a blank is missing behind the hyphen of this list entry; write - and a blank");
  }

  /// Anchors and tags before a value.
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
      items_.push_back({Form::text, line, column, false, whole});
      return pass_end(first);
    }
    items_.push_back({Form::key, line, column, false, text_.between(begin, text_.position())});
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

  /// What may stand behind a value in quotes or brackets: nothing.
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

  /// A text behind | or >: all lines that are indented further than its key.
  void pass_block_text(int column) {
    while (text_.indentation_of_next_line() > column) text_.next_line();
    while (!text_.at_line_end()) text_.advance();
  }

  LayoutText text_;
  std::vector<Item> items_;
};

/// A block map or list that is open at the current line.
struct Level {
  Form form;  ///< of its entries; text: a plain text over several lines
  int column;
  std::size_t first;  ///< item
  std::size_t last;   ///< item so far
};

class BlockStructure {
 public:
  explicit BlockStructure(const std::vector<Item>& items) : items_(items) {}

  std::optional<LayoutMistake> first_mistake() {
    for (at_ = 0; at_ < items_.size() && !found_; ++at_) add(items_[at_]);
    return found_;
  }

 private:
  void add(const Item& item) {
    std::optional<Level> left;
    while (!levels_.empty() && levels_.back().column > item.column) {
      left = levels_.back();
      levels_.pop_back();
    }
    // A list may stand in the column of its key.
    if (item.form != Form::hyphen && levels_.size() > 1 && levels_.back().form == Form::hyphen &&
        levels_[levels_.size() - 2].column == item.column)
      levels_.pop_back();
    if (!levels_.empty() && levels_.back().column == item.column) return go_on(item);
    if (left && levels_.empty()) return uneven(*left, {}, item);
    if (left && item.form == Form::hyphen && levels_.back().form == Form::hyphen)
      return uneven(levels_.back(), around(), item);
    if (left) return uneven(*left, levels_.back().column, item);
    if (!levels_.empty() && !items_[levels_.back().last].open) {
      if (item.form != Form::text) uneven(levels_.back(), around(), item);
      return;  // a text goes on
    }
    levels_.push_back({item.form, item.column, at_, at_});
  }

  /// Column of the level around the innermost one.
  std::optional<int> around() const {
    if (levels_.size() < 2) return std::nullopt;
    return levels_[levels_.size() - 2].column;
  }

  void go_on(const Item& item) {
    Level& level = levels_.back();
    const Item& before = items_[level.last];
    if (item.form == Form::hyphen && level.form == Form::key && before.open) {
      levels_.push_back({Form::hyphen, item.column, at_, at_});
      return;
    }
    if (item.form == level.form) {
      level.last = at_;
      return;
    }
    if (item.form == Form::text) return level.form == Form::key ? no_colon(item) : no_hyphen(item);
    if (level.form == Form::text) return no_colon(items_[level.first]);
    if (level.form == Form::hyphen)
      return mistake(item,
                     fmt::format("this line begins in the column of the list's hyphens (line {}) and has none; write "
                                 "the hyphen, or indent the line as the other keys of its entry",
                                 before.line));
    mistake(item, fmt::format("a hyphen begins an entry of a list here, but line {} above is a key of the map that "
                              "this line belongs to; indent the list under its key",
                              before.line));
  }

  void no_hyphen(const Item& item) {
    mistake(item, fmt::format("a hyphen is missing: the entries of this list, from line {} on, begin with one",
                              items_[levels_.back().first].line));
  }

  /// A line of a map without `key: `. Says how to write it where its first word shows what was meant.
  void no_colon(const Item& item) {
    const std::string& text = item.text;
    const auto of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
    const auto end = static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), of_word) - text.begin());
    const std::string word = text.substr(0, end);
    const std::size_t value = text.find_first_not_of(" \t", end);
    if (word.empty() || value == std::string::npos)
      return mistake(item,
                     "this is neither a key with a colon behind it nor an entry of a list with a hyphen before it");
    const auto written = [&](std::size_t from) {
      const std::size_t begin = text.find_first_not_of(" \t", from);
      const std::string rest = begin == std::string::npos ? "" : text.substr(begin);
      return word + ":" + (rest.empty() || rest.size() > 60 ? " ..." : " " + rest);
    };
    if (text[end] == ':')
      return mistake(item, fmt::format("a blank is missing behind the colon of {}; write {}", word, written(end + 1)));
    if (text[end] == '=')
      return mistake(item, fmt::format("a key is followed by a colon, not by =; write {}", written(end + 1)));
    if (text[value] == '=' || text[value] == ':')
      return mistake(item, fmt::format("a colon belongs between {} and its value; write {}", word, written(value + 1)));
    mistake(item, fmt::format("a colon is missing behind {}; write {}", word, written(end)));
  }

  /// Two lines of one block that begin in different columns. The column that fewer of the block's lines have is the
  /// slip; where it is a draw, the odd one, or else the later line.
  void uneven(const Level& level, std::optional<int> around, const Item& item) {
    std::size_t end = at_;
    while (end < items_.size() && (!around || items_[end].column > *around)) ++end;
    const auto at_column = [&](int column) {
      return std::count_if(items_.begin() + static_cast<std::ptrdiff_t>(level.first),
                           items_.begin() + static_cast<std::ptrdiff_t>(end),
                           [&](const Item& other) { return other.column == column; });
    };
    const auto earlier = at_column(level.column), later = at_column(item.column);
    const bool odd = level.column % 2 == 1 && item.column % 2 == 0;
    const bool blame_later = later < earlier || (later == earlier && !odd);
    const Item& first = items_[level.first];
    const Item& nearest = items_[levels_.empty() || level.column != levels_.back().column ? level.first : level.last];
    if (blame_later && item.column >= level.column + 2)
      return mistake(item, fmt::format("this line is indented as if it belonged to {} in line {}, which has a value "
                                       "already; take that value away, or let both begin in column {}",
                                       nearest.text.substr(0, 60), nearest.line, level.column + 1));
    if (blame_later) return columns_differ(item, nearest);
    columns_differ(first, item);
  }

  void columns_differ(const Item& wrong, const Item& right) {
    const auto name = [](const Item& item) {
      return item.form == Form::hyphen ? std::string("the hyphen") : item.text.substr(0, 60);
    };
    const bool may_lack_hyphen = wrong.form == Form::key && right.form == Form::key && wrong.column + 2 == right.column;
    mistake(wrong, fmt::format("the indentation does not fit: {} begins in column {}, but {} in line {} of the same "
                               "block in column {}; let both begin in one column{}",
                               name(wrong), wrong.column + 1, name(right), right.line, right.column + 1,
                               may_lack_hyphen ? ", or write the hyphen of a list's entry before the first" : ""));
  }

  void mistake(const Item& item, std::string sentence) {
    if (!found_) found_ = LayoutMistake{item.line, item.column + 1, std::move(sentence), false};
  }

  const std::vector<Item>& items_;
  std::vector<Level> levels_;
  std::size_t at_ = 0;
  std::optional<LayoutMistake> found_;
};

}  // namespace

std::optional<LayoutMistake> find_layout_mistake(const std::string& yaml) {
  if (yaml.empty()) return std::nullopt;
  const ItemReader reader(yaml);
  const std::optional<LayoutMistake> of_blocks = BlockStructure(reader.items()).first_mistake();
  return of_blocks ? of_blocks : reader.mistake();
}

}  // namespace perinox::deck
