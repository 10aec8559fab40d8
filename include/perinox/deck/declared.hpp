#pragma once
/// YAML files that are no decks, declared and checked by the same means as decks.
#include <string>

#include "perinox/deck/schema.hpp"
#include "perinox/deck/value.hpp"

namespace perinox::deck {

/// Reads `file` and checks it against the keys of `root`, which refers to no definitions. `kind` is what messages call
/// the file: "study". Throws InputError with `file:line:column: sentence`.
Value read_declared(const std::string& file, const Key& root, const std::string& kind);
/// The same from text; `file` is only named in messages.
Value read_declared_text(const std::string& yaml, const std::string& file, const Key& root, const std::string& kind);

/// The keys inside `root` as a Markdown table: key, type, default, range and sentence.
std::string key_table(const Key& root);

}  // namespace perinox::deck
