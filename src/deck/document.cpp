#include "document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "columns.hpp"
#include "layout.hpp"

namespace perinox::deck {
namespace {

constexpr int deepest = 60;
/// A value that is written out takes at least one character of the text; only aliases make more values than that. This
/// many more are allowed.
constexpr std::size_t most_from_aliases = 10'000;

class TreeBuilder {
 public:
  TreeBuilder(const std::string& file, const std::string& yaml)
      : file_(file), yaml_(yaml), columns_(yaml), most_nodes_(yaml.size() + most_from_aliases) {}

  Node build(const YAML::Node& yaml, const Location& around, int depth) {
    Node node;
    node.location = place(yaml, around);
    if (depth > deepest) {
      refuse(node.location,
             fmt::format("lists and maps are nested more than {} deep here; a deck never needs that", deepest));
    }
    if (++nodes_ > most_nodes_) {
      refuse(node.location, fmt::format("the aliases (*name) stand for more than {} values when they are written out; "
                                        "put large data in a file",
                                        most_from_aliases));
    }
    if (yaml.IsScalar()) {
      node.kind = Node::Kind::scalar;
      node.text = yaml.Scalar();
      node.quoted = yaml.Tag() == "!";
      if (!node.quoted) node.goes_on = place_in_next_line(node, yaml.Mark().column);
    } else if (yaml.IsSequence()) {
      node.kind = Node::Kind::list;
      for (const auto& item : yaml) node.items.push_back(build(item, node.location, depth + 1));
    } else if (yaml.IsMap()) {
      node.kind = Node::Kind::map;
      for (const auto& entry : yaml) add_entry(node, entry.first, entry.second, depth);
    }
    return node;
  }

 private:
  void add_entry(Node& map, const YAML::Node& key, const YAML::Node& value, int depth) {
    const Location where = place(key, map.location);
    if (!key.IsScalar() || key.Scalar().empty()) {
      refuse(where, "a key is missing or is not a word here; check the commas and colons of this map");
    }
    map.entries.push_back({key.Scalar(), where, build(value, where, depth + 1)});
  }

  /// The place of a node. yaml-cpp marks an empty value behind itself, so it is better named by what is around it.
  Location place(const YAML::Node& yaml, const Location& around) const {
    const YAML::Mark mark = yaml.Mark();
    if (mark.line < 0 || yaml.IsNull()) return around;
    return {file_, mark.line + 1, columns_.of(mark.line + 1, mark.column)};
  }

  /// The place where a scalar without quotes goes on in a later line. Line 0 if it ends on its own line.
  Location place_in_next_line(const Node& scalar, int bytes) const {
    if (scalar.text.find(' ') == std::string::npos || scalar.location.line <= 0) return {};
    const std::vector<std::size_t>& line_starts = columns_.line_starts();
    const auto line = static_cast<std::size_t>(scalar.location.line);
    if (line >= line_starts.size()) return {};
    // The mark of a scalar may stand at an anchor before it.
    constexpr std::size_t longest_anchor = 200;
    const std::size_t begin =
        std::min(line_starts[line - 1] + static_cast<std::size_t>(std::max(bytes, 0)), yaml_.size());
    const std::size_t end = std::min(line_starts[line], begin + scalar.text.size() + longest_anchor);
    if (std::string_view(yaml_).substr(begin, end - begin).find(scalar.text) != std::string_view::npos) return {};
    for (std::size_t later = line; later < line_starts.size(); ++later) {
      const std::size_t first = yaml_.find_first_not_of(" \t\r", line_starts[later]);
      if (first != std::string::npos && yaml_[first] != '\n')
        return {file_, static_cast<int>(later) + 1, static_cast<int>(first - line_starts[later]) + 1};
    }
    return {};
  }

  std::string file_;
  const std::string& yaml_;
  const Columns columns_;
  std::size_t most_nodes_;
  std::size_t nodes_ = 0;
};

/// Refuses the text at the slip in its layout, or with `sentence` at `where` if there is no slip before that place.
[[noreturn]] void refuse_layout(const std::string& yaml, const Location& where, const std::string& sentence) {
  const auto slip = find_layout_mistake(yaml);
  if (slip && (where.line <= 0 || slip->line <= where.line))
    refuse({where.file, slip->line, slip->column}, slip->sentence);
  refuse(where, sentence);
}

/// Notes only where documents start.
class DocumentStarts : public YAML::EventHandler {
 public:
  YAML::Mark latest;
  void OnDocumentStart(const YAML::Mark& mark) override { latest = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

/// Refuses a text of more than one document. yaml-cpp takes a comma or bracket outside of any list for the start of
/// endless empty documents, so no more than two are ever asked for.
void refuse_second_document(const std::string& yaml, const std::string& file) {
  std::istringstream stream(yaml);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  if (!parser.HandleNextDocument(starts) || !parser.HandleNextDocument(starts)) return;
  const YAML::Mark mark = starts.latest;
  const int line_of_mark = std::max(mark.line, 0) + 1;
  const Location where{file, line_of_mark, Columns(yaml).of(line_of_mark, std::max(mark.column, 0))};
  std::size_t begin = 0;
  for (int line = 1; line < where.line && begin < yaml.size(); ++line) begin = yaml.find('\n', begin) + 1;
  if (yaml.compare(begin, 3, "---") == 0) {
    refuse(where, "a second YAML document starts here; a deck is one document, so remove the line ---");
  }
  refuse_layout(yaml, where, "this does not belong to the lines above; check indentation, commas and brackets");
}

std::string syntax_sentence(const std::string& message) {
  const auto says = [&](const char* part) { return message.find(part) != std::string::npos; };
  if (says("end of sequence flow")) return "the list opened with [ here is not closed, or a comma is missing in it";
  if (says("end of map flow")) return "the map opened with { here is not closed, or a comma is missing in it";
  if (says("illegal flow end"))
    return "this closing bracket does not fit the bracket that was opened last, or none was opened";
  if (says("illegal map value")) {
    return "a second colon on this line; put each key on a line of its own, or quotes around a text with a colon";
  }
  if (says("illegal EOF in scalar")) return "a text in quotes is not closed";
  if (says("referenced anchor"))
    return "the alias (*name) refers to an anchor (&name) that is not defined before it; put a text "
           "that begins with * in quotes";
  if (says("unknown token")) return "this character cannot start a value in YAML; put the text in quotes";
  if (says("end of map not found") || says("end of sequence not found")) {
    return "the indentation does not fit the lines above, or a colon or hyphen is missing";
  }
  return "this is not YAML (" + message + "); check indentation, colons and brackets near here";
}

/// Splits `a.b.c` into its words.
std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> words(1);
  for (const char c : path) {
    if (c == '.') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}

void place_everywhere(Node& node, const Location& where) {
  node.location = where;
  for (Node& item : node.items) place_everywhere(item, where);
  for (Entry& entry : node.entries) {
    entry.location = where;
    place_everywhere(entry.value, where);
  }
}

Node& step_into_list(Node& list, const std::string& word, const std::string& name, const Location& where) {
  const bool digits = !word.empty() && word.size() < 10 &&
                      std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) {
    refuse(where, fmt::format("{} is a list; name an entry by its number, counted from 0, instead of {}", name, word));
  }
  const auto index = static_cast<std::size_t>(std::stoul(word));
  if (index >= list.items.size()) {
    refuse(where, fmt::format("{} has {} {}, counted from 0; there is no entry {}", name, list.items.size(),
                              list.items.size() == 1 ? "entry" : "entries", index));
  }
  return list.items[index];
}

}  // namespace

std::string Node::description() const {
  switch (kind) {
    case Kind::scalar:
      return "'" + text + "'";
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
    case Kind::null:
      break;
  }
  return "nothing";
}

const Node* Node::find(const std::string& key) const {
  for (const Entry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

Node parse_yaml(const std::string& yaml, const std::string& file) {
  try {
    refuse_second_document(yaml, file);
    return TreeBuilder(file, yaml).build(YAML::Load(yaml), {file, 1, 1}, 0);
  } catch (const YAML::DeepRecursion& error) {
    refuse({file, error.mark.line + 1, error.mark.column + 1}, "lists and maps are nested far too deep here");
  } catch (const YAML::Exception& error) {
    const int line = error.mark.line < 0 ? 0 : error.mark.line + 1;
    refuse_layout(yaml, {file, line, line == 0 ? 0 : Columns(yaml).of(line, error.mark.column)},
                  syntax_sentence(error.msg));
  }
}

void refuse_hidden_slip(const std::string& yaml, const std::string& file) {
  const auto slip = find_layout_mistake(yaml);
  if (slip && slip->hidden) refuse({file, slip->line, slip->column}, slip->sentence);
}

void apply_override(Node& root, const std::string& override_text) {
  const Location where{"--set " + override_text, 0, 0};
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos || equals == 0) {
    refuse(where, "an override is written key.path=value, for example solver.newton.tolerance=1e-9");
  }
  Node value = parse_yaml(override_text.substr(equals + 1), where.file);
  place_everywhere(value, where);

  Node* node = &root;
  std::string name = "the deck";
  for (const std::string& word : split_path(override_text.substr(0, equals))) {
    if (word.empty()) refuse(where, "the key's path has an empty part; write it as key.path=value");
    if (node->kind == Node::Kind::list) {
      node = &step_into_list(*node, word, name, where);
    } else if (node->kind == Node::Kind::scalar) {
      refuse(where, fmt::format("{} is {} and has no keys; set {} itself", name, node->description(), name));
    } else {
      if (node->kind == Node::Kind::null) node->location = where;
      node->kind = Node::Kind::map;
      const auto found = std::find_if(node->entries.begin(), node->entries.end(),
                                      [&](const Entry& entry) { return entry.key == word; });
      if (found != node->entries.end()) {
        node = &found->value;
      } else {
        node->entries.push_back({word, where, Node{}});
        node = &node->entries.back().value;
        node->location = where;
      }
    }
    name = word;
  }
  *node = std::move(value);
}

}  // namespace perinox::deck
