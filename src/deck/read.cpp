#include "perinox/deck/read.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "check.hpp"
#include "convert.hpp"
#include "document.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/declared.hpp"

namespace perinox::deck {
namespace {

constexpr std::size_t longest_file = 64 << 20;

std::string content_of(const std::string& file, const std::string& kind) {
  namespace fs = std::filesystem;
  const Location where{file, 0, 0};
  std::error_code error;
  if (!fs::exists(file, error)) refuse(where, "there is no " + kind + " of this name; check the path");
  if (fs::is_directory(file, error)) refuse(where, "this is a folder; name the " + kind + " file in it");
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::vector<char> piece(1 << 16);
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())), stream.gcount() > 0) {
    text.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > longest_file)  // a device never ends
      refuse(where, "the " + kind + " is longer than 64 MB; put large data in a file of its own");
  }
  if (!stream.is_open() || stream.bad()) {
    refuse(where, "the " + kind + " cannot be read (" + std::strerror(errno) + "); check its permissions");
  }
  return text;
}

/// Gives a deck without a title the name of its file.
Value with_title(const Value& checked, const std::string& file) {
  if (checked.has("title")) return checked;
  std::string stem = std::filesystem::path(file).stem().string();
  if (stem.empty()) stem = "deck";
  std::vector<std::pair<std::string, Value>> entries{{"title", Value::scalar(stem, checked.location(), false)}};
  entries.insert(entries.end(), checked.entries().begin(), checked.entries().end());
  return Value::map(std::move(entries), checked.location(), true);
}

/// Checks a text that has been read as YAML. Where it is refused, a slip that gave it another meaning is named instead.
template <class Check>
auto refusing_slips(const std::string& yaml, const std::string& file, Check&& check) {
  try {
    return check();
  } catch (const InputError&) {
    refuse_hidden_slip(yaml, file);
    throw;
  }
}

Deck read_node(const std::string& yaml, const std::string& file, const Schema& schema,
               const std::vector<std::string>& overrides, bool files_may_be_gone) {
  Node root = parse_yaml(yaml, file);
  if (root.kind == Node::Kind::null) {
    refuse({file, 0, 0}, "the deck is empty; it needs at least dimension, body, horizon and materials");
  }
  for (const std::string& text : overrides) apply_override(root, text);
  const InputFiles files{folder_of(file), files_may_be_gone};
  return refusing_slips(yaml, file,
                        [&] { return convert(with_title(check_against_schema(root, schema, files), file), file); });
}

}  // namespace

std::string folder_of(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().parent_path().string();
}

Deck read_text(const std::string& yaml, const std::string& file, const Schema& schema,
               const std::vector<std::string>& overrides) {
  return read_node(yaml, file, schema, overrides, false);
}

Deck read_saved(const std::string& yaml, const std::string& file, const Schema& schema) {
  return read_node(yaml, file, schema, {}, true);
}

Deck read(const std::string& file, const Schema& schema, const std::vector<std::string>& overrides) {
  return read_text(content_of(file, "deck"), file, schema, overrides);
}

Value read_declared(const std::string& file, const Key& root, const std::string& kind) {
  return read_declared_text(content_of(file, kind), file, root, kind);
}

Value read_declared_text(const std::string& yaml, const std::string& file, const Key& root, const std::string& kind) {
  const Node node = parse_yaml(yaml, file);
  if (node.kind == Node::Kind::null) refuse({file, 0, 0}, "the " + kind + " is empty");
  return refusing_slips(yaml, file, [&] { return check_against_key(node, root, "the " + kind, {folder_of(file)}); });
}

}  // namespace perinox::deck
