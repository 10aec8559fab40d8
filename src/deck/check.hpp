#pragma once
/// Applies the schema to a YAML tree.
#include <string>

#include "document.hpp"
#include "perinox/deck/schema.hpp"
#include "perinox/deck/value.hpp"

namespace perinox::deck {

/// The files that a tree names.
struct InputFiles {
  std::string folder;        ///< absolute path from which relative names count
  bool may_be_gone = false;  ///< they are not looked for, because nobody will read them
};

/// The tree as a Value with every default filled in, numbers in canonical text and paths absolute. Throws InputError at
/// the first thing that the schema does not allow.
Value check_against_schema(const Node& root, const Schema& schema, const InputFiles& files);

/// Checks the tree of a file that is no deck and refers to no definitions. Messages call its root `name`.
Value check_against_key(const Node& root, const Key& key, const std::string& name, const InputFiles& files);

/// Checks a scalar of the schema. Throws InputError for a wrong type, a number out of range, an unknown word and a
/// missing file.
Value check_scalar(const Node& node, const Key& key, const std::string& name, const InputFiles& files);

/// Describes what a value of this key looks like, for messages and the reference page: "a number", "a list of numbers",
/// ...
std::string expected(const Key& key);
/// Describes the range of a key: "greater than 0", "from 0 to 60", "at least 1"; "" if there is no limit.
std::string range_text(const Key& key);

}  // namespace perinox::deck
