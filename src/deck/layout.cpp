#include "layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "columns.hpp"
#include "layout_items.hpp"

namespace perinox::deck {
namespace {

using Form = LayoutForm;
using Item = LayoutItem;

/// A block map or list that is open at the current line.
struct Level {  ///< form of its entries; text: a plain text over several lines
  Form form;    ///< of its entries; text: a plain text over several lines
  int column;
  std::size_t first;  ///< its first item
  std::size_t last;   ///< its last item so far
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

  /// Refuses a line of a map without `key: `. It says how to write the line where its first word shows what was meant.
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

  /// Refuses two lines of one block that begin in different columns. The slip is the column that fewer of the block's
  /// lines have; in a draw it is the odd column, or else the later line.
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
  const LayoutItems read = read_layout_items(yaml);
  std::optional<LayoutMistake> found = BlockStructure(read.items).first_mistake();
  if (!found) found = read.mistake;
  if (found) found->column = Columns(yaml).of(found->line, found->column - 1);
  return found;
}

}  // namespace perinox::deck
