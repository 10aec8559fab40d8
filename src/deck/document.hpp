#pragma once
/// YAML as a plain tree in which every node and key knows its place. Nothing here knows the schema.
#include <string>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::deck {

struct Entry;
struct Node {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  Location location;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< a scalar in quotes is text, never a number
  Location goes_on;     ///< place where a scalar without quotes goes on in a later line; line 0: nowhere
  std::vector<Node> items;
  std::vector<Entry> entries;  ///< in the file's order; a key written twice is there twice

  /// What a message calls this node: 'abc', a list, a map, nothing.
  std::string description() const;
  /// The value of a key, or nullptr if there is no such key.
  const Node* find(const std::string& key) const;
};
struct Entry {
  std::string key;
  Location location;
  Node value;
};

/// Parses a YAML text. Throws InputError for anything that is not one YAML document of reasonable depth and size.
Node parse_yaml(const std::string& yaml, const std::string& file);

/// For a text that is YAML but no deck: throws InputError at a slip of the keyboard that has given the text another
/// meaning, such as quotes that were never closed. It returns if there is no such slip.
void refuse_hidden_slip(const std::string& yaml, const std::string& file);

/// Replaces or adds the value at a dotted path, as in `solver.newton.tolerance=1e-9` and `body.0.spacing=0.1`. The
/// place of the new nodes is the override itself. Throws InputError if the path runs through a scalar or past the end
/// of a list.
void apply_override(Node& root, const std::string& override_text);

}  // namespace perinox::deck
