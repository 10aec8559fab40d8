#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// Reads and checks a deck. `overrides` are the `key.path=value` strings of `--set`. Paths of clouds and tables are
/// made relative to the deck's folder. Throws InputError with `file:line:column: sentence`.
Deck read(const std::string& file, const Schema& schema, const std::vector<std::string>& overrides = {});
/// Reads and checks a deck from text. `file` is only named in messages.
Deck read_text(const std::string& yaml, const std::string& file, const Schema& schema,
               const std::vector<std::string>& overrides = {});
/// Reads a deck that a checkpoint holds, to compare it with another. The files that it names need not exist any more.
Deck read_saved(const std::string& yaml, const std::string& file, const Schema& schema);
/// Absolute path of the folder from which the names in a file count.
std::string folder_of(const std::string& file);

/// The deck with every default filled in, as YAML. In a file of `folder` it reads back to the same deck: names of input
/// files that are relative in the deck are relative to that folder. Without a folder all of them are absolute.
std::string write_resolved(const Deck& deck, const std::string& folder = "");

/// An input file that a deck names.
struct InputFile {
  std::string key;   ///< "body[0].shape.file"
  std::string path;  ///< path that opens the file
};
/// All input files that the deck names, in the order of the keys.
std::vector<InputFile> input_files(const Deck& deck);

/// The candidate nearest to `word` by edit distance, or "" if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace perinox::deck
