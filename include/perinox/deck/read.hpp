#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// Reads and checks a deck. `overrides` are `key.path=value` strings of `--set`. Paths of clouds and tables are made
/// relative to the deck's folder. Throws InputError with `file:line:column: sentence`.
Deck read(const std::string& file, const Schema& schema, const std::vector<std::string>& overrides = {});
/// The same from text; `file` is only named in messages.
Deck read_text(const std::string& yaml, const std::string& file, const Schema& schema,
               const std::vector<std::string>& overrides = {});
/// The deck with every default filled in, as YAML that reads back to the same deck. Input-file paths in it are
/// absolute, so that it runs from the results folder.
std::string write_resolved(const Deck& deck);

/// The candidate nearest to `word` by edit distance, or "" if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace perinox::deck
