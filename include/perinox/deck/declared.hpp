#pragma once
/// Reads YAML files that are no decks. They are declared and checked by the same means as decks.
#include <string>

#include "perinox/deck/schema.hpp"
#include "perinox/deck/value.hpp"

namespace perinox::deck {

/// Reads `file` and checks it against the keys of `root`, which must refer to no definitions. Messages call the file a
/// `kind`, such as "study". Throws InputError with `file:line:column: sentence`.
Value read_declared(const std::string& file, const Key& root, const std::string& kind);
/// Reads and checks YAML from text. `file` is only named in messages.
Value read_declared_text(const std::string& yaml, const std::string& file, const Key& root, const std::string& kind);

/// The keys inside `root` as a Markdown table with key, type, default, range and sentence.
std::string key_table(const Key& root);

}  // namespace perinox::deck
