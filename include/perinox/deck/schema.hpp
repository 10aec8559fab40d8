#pragma once
/// The one declaration of everything a deck may say. Validation, defaults, `perinox help KEY`, docs/deck.md and the
/// JSON Schema for editors all come from it.
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace perinox::deck {

enum class Type {
  number,  ///< finite real
  integer,
  boolean,
  text,
  word,        ///< one of `words`
  path,        ///< file name, relative to the deck's folder
  expression,  ///< number or formula of x, y, z, t
  point,       ///< list of 2 or 3 numbers
  list,        ///< list of `element`
  map,         ///< fixed `keys`
  choice,      ///< map with exactly one of `keys`
  named,       ///< map from names chosen by the user to `element`
};

struct Key {
  std::string name;
  Type type = Type::number;
  std::string unit;      ///< "length", "stress", "force", "-" ...
  std::string sentence;  ///< what it means, one sentence
  bool required = false;
  std::optional<std::string> fallback;     ///< default, as YAML text
  std::optional<double> minimum, maximum;  ///< of numbers and integers
  bool exclusive_minimum = false;
  std::vector<std::string> words;
  std::vector<Key> keys;
  std::vector<Key> element;  ///< list and named: exactly one entry

  /// The keys are those of the schema's definition of this name (shapes contain shapes).
  std::string reference;
  /// Of a map: groups of keys of which exactly one group is used; a choice has one group for each key.
  std::vector<std::vector<std::string>> alternatives;
  /// What messages call a map with these keys: "a material". Empty: the dotted path.
  std::string place;
  /// The map's key `model` names a ModelDeclaration, whose keys are then allowed beside `keys`.
  bool picks_model = false;
  std::size_t minimum_items = 0;  ///< of a list
  bool unique = false;            ///< a list without repetitions
  bool names_field = false;       ///< a word that is the name of an output field
  std::string example;            ///< YAML of a top-level key, for the reference page
};

/// A field of results.h5, which output.fields may name.
struct FieldDeclaration {
  std::string name;
  std::string sentence;    ///< what it is, one sentence
  std::string unit;        ///< as of a Key
  std::string components;  ///< how many values a particle has, and which
  std::string exists;      ///< in which dimensions and with which materials and decks: "in every run"
  bool plane_only = false;
};

/// What a material model declares about itself; the materials room hands these over.
struct ModelDeclaration {
  std::string name;
  std::string sentence;
  std::vector<Key> keys;
  std::vector<FieldDeclaration> fields{};  ///< point history variables
};

class Schema {
 public:
  explicit Schema(std::vector<ModelDeclaration> models);
  const Key& root() const { return root_; }
  /// The key that others refer to by this name. Throws std::logic_error if there is none.
  const Key& definition(const std::string& name) const;
  /// The key whose type, keys and alternatives hold for this one: itself, or the definition it refers to.
  const Key& structure(const Key& key) const { return key.reference.empty() ? key : definition(key.reference); }
  const std::map<std::string, Key>& definitions() const { return definitions_; }
  const std::vector<ModelDeclaration>& models() const { return models_; }
  /// nullptr if there is no model of this name.
  const ModelDeclaration* model(const std::string& name) const;

  /// The output fields of every scene, then those of the models.
  const std::vector<FieldDeclaration>& fields() const { return fields_; }
  /// nullptr if there is no field of this name.
  const FieldDeclaration* field(const std::string& name) const;

  /// Documentation of one key by its dotted path (`solver.newton.tolerance`, `materials.elastic.bulk_modulus`), of
  /// every key with that last name, and of the output field of this name. Throws InputError with the nearest name if
  /// there is none.
  std::string help(const std::string& path) const;
  /// docs/deck.md, whole.
  std::string reference_page() const;
  /// JSON Schema (draft 7), indented.
  std::string json_schema() const;

 private:
  Key root_;
  std::map<std::string, Key> definitions_;
  std::vector<ModelDeclaration> models_;
  std::vector<FieldDeclaration> fields_;
};

}  // namespace perinox::deck
