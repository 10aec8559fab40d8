#pragma once
/// Describes the schema's keys in words, for `perinox help` and the reference page.
#include <string>
#include <vector>

#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// One key and its place. `path` is dotted and leaves out list entries and names chosen by the user. A material's own
/// keys carry their model's name (`materials.elastic.bulk_modulus`), which `path_without_model` leaves out.
struct DescribedKey {
  std::string path;
  std::string path_without_model;
  const Key* key = nullptr;
  bool alternative = false;  ///< one of several keys that exclude each other
};

/// All keys of the deck, outer ones before inner ones. Shapes within shapes are listed once.
std::vector<DescribedKey> every_key(const Schema& schema);
/// The keys inside `key`, with paths relative to it. Definitions to which it refers are not entered.
std::vector<DescribedKey> keys_inside(const Key& key);

/// The type of a key in words: "number", "list of words: a, b", "exactly one of box, cylinder, ...".
std::string type_text(const Key& key, const Schema& schema);
/// The unit in words: "length", "dimensionless", or "" for what has no unit.
std::string unit_text(const std::string& unit);
/// The default in words: "required", "alternative", "optional", or the default as YAML.
std::string default_text(const DescribedKey& described);
/// True if `key` names one of several groups of keys that exclude each other in `map`.
bool is_alternative(const Key& map, const Key& key);
/// Describes the key in a few lines for the terminal, with the keys inside it.
std::string help_text(const DescribedKey& described, const Schema& schema);
/// Describes an output field in a few lines for the terminal.
std::string field_text(const FieldDeclaration& field);

}  // namespace perinox::deck
