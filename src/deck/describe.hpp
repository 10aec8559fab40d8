#pragma once
/// The schema's keys in words, for `perinox help` and the reference page.
#include <string>
#include <vector>

#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// One key and where it is: `path` is dotted, list entries and user-chosen names left out; a material's own keys carry
/// their model's name (`materials.elastic.bulk_modulus`), which `path_without_model` leaves out.
struct DescribedKey {
  std::string path;
  std::string path_without_model;
  const Key* key = nullptr;
  bool alternative = false;  ///< one of several keys that exclude each other
};

/// Every key of the deck, outer before inner. Shapes within shapes are listed once.
std::vector<DescribedKey> every_key(const Schema& schema);
/// The keys inside `key`, relative to it, not entering definitions it refers to.
std::vector<DescribedKey> keys_inside(const Key& key);

/// "number", "list of words: a, b", "exactly one of box, cylinder, ...".
std::string type_text(const Key& key, const Schema& schema);
/// "length", "dimensionless", or "" for what has no unit.
std::string unit_text(const std::string& unit);
/// "required", "alternative", "optional", or the default as YAML.
std::string default_text(const DescribedKey& described);
/// True if `key` names one of several groups of keys that exclude each other in `map`.
bool is_alternative(const Key& map, const Key& key);
/// The key in a few lines for the terminal, with the keys inside it.
std::string help_text(const DescribedKey& described, const Schema& schema);
/// An output field in a few lines for the terminal.
std::string field_text(const FieldDeclaration& field);

}  // namespace perinox::deck
