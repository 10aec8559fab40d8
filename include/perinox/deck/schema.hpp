#pragma once
/// The one declaration of everything that a deck may say. Validation, defaults, `perinox help KEY`, docs/deck.md and
/// the JSON Schema for editors all come from it.
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

/// The declaration of one key.
struct Key {
  std::string name;
  Type type = Type::number;
  std::string unit;      ///< "length", "stress", "force", "-" ...
  std::string sentence;  ///< what the key means, one sentence
  bool required = false;
  std::optional<std::string> fallback;     ///< default, as YAML text
  std::optional<double> minimum, maximum;  ///< bounds of numbers and integers
  bool exclusive_minimum = false;
  std::vector<std::string> words;
  std::vector<Key> keys;
  std::vector<Key> element;  ///< list and named: exactly one entry

  /// Name of the definition in the schema whose keys this one has (shapes contain shapes).
  std::string reference;
  /// Groups of keys of a map, of which exactly one group is used. A choice has one group for each key.
  std::vector<std::vector<std::string>> alternatives;
  /// What messages call a map with these keys, such as "a material". If it is empty they use the dotted path.
  std::string place;
  /// True if the map's key `model` names a ModelDeclaration, whose keys are then allowed beside `keys`.
  bool picks_model = false;
  std::size_t minimum_items = 0;  ///< least length of a list
  bool unique = false;            ///< a list must be without repetitions
  bool names_field = false;       ///< a word must be the name of an output field
  std::string example;            ///< YAML example of a top-level key, for the reference page
};

/// A field of results.h5, which output.fields may name.
struct FieldDeclaration {
  std::string name;
  std::string sentence;    ///< what the field is, one sentence
  std::string unit;        ///< unit, in the words of Key::unit
  std::string components;  ///< number of values of a particle, and which ones they are
  std::string exists;      ///< dimensions, materials and decks for which it exists: "in every run"
  bool plane_only = false;
};

/// What a material model declares about itself. The room materials hands these declarations over.
struct ModelDeclaration {
  std::string name;
  std::string sentence;
  std::vector<Key> keys;
  std::vector<FieldDeclaration> fields{};  ///< the point history variables
};

/// The keys of the deck, with those of the given material models.
class Schema {
 public:
  explicit Schema(std::vector<ModelDeclaration> models);
  const Key& root() const { return root_; }
  /// The key to which others refer by this name. Throws std::logic_error if there is none.
  const Key& definition(const std::string& name) const;
  /// The key whose type, keys and alternatives hold for this one: itself, or the definition to which it refers.
  const Key& structure(const Key& key) const { return key.reference.empty() ? key : definition(key.reference); }
  const std::map<std::string, Key>& definitions() const { return definitions_; }
  const std::vector<ModelDeclaration>& models() const { return models_; }
  /// The model of this name, or nullptr if there is none.
  const ModelDeclaration* model(const std::string& name) const;

  /// The output fields of every scene, followed by those of the models.
  const std::vector<FieldDeclaration>& fields() const { return fields_; }
  /// The output field of this name, or nullptr if there is none.
  const FieldDeclaration* field(const std::string& name) const;

  /// Documentation of one key by its dotted path (`solver.newton.tolerance`, `materials.elastic.bulk_modulus`), of
  /// every key with that last name, and of the output field of this name. Throws InputError with the nearest name if
  /// there is none.
  std::string help(const std::string& path) const;
  /// The whole text of docs/deck.md.
  std::string reference_page() const;
  /// The schema as a JSON Schema (draft 7), indented.
  std::string json_schema() const;

 private:
  Key root_;
  std::map<std::string, Key> definitions_;
  std::vector<ModelDeclaration> models_;
  std::vector<FieldDeclaration> fields_;
};

}  // namespace perinox::deck
