#include "describe.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "check.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

std::string join(const std::string& path, const std::string& name) { return path.empty() ? name : path + "." + name; }

class Walker {
 public:
  /// Without a schema, definitions and models are not entered.
  explicit Walker(const Schema* schema) : schema_(schema) {}

  void enter(const Key& key, const std::string& path, const std::string& short_path) {
    if (!key.reference.empty()) {
      if (schema_ == nullptr || std::count(inside_.begin(), inside_.end(), key.reference) > 0) return;
      inside_.push_back(key.reference);
      enter(schema_->definition(key.reference), path, short_path);
      inside_.pop_back();
      return;
    }
    for (const Key& element : key.element) enter(element, path, short_path);
    for (const Key& inner : key.keys) add(inner, path, short_path, is_alternative(key, inner));
    if (!key.picks_model || schema_ == nullptr) return;
    for (const ModelDeclaration& model : schema_->models()) {
      for (const Key& own : model.keys) add(own, join(path, model.name), short_path, false);
    }
  }

  std::vector<DescribedKey> found;

 private:
  void add(const Key& key, const std::string& path, const std::string& short_path, bool alternative) {
    const std::string full = join(path, key.name);
    const std::string without_model = join(short_path, key.name);
    found.push_back({full, without_model, &key, alternative});
    enter(key, full, without_model);
  }

  const Schema* schema_;
  std::vector<std::string> inside_;
};

std::vector<std::string> names_of(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.push_back(key.name);
  return names;
}

/// The alternatives of a map in words: "exactly one of box, cylinder or sphere"; "at least one of x, y or z"; "x, y, z
/// or else table".
std::string alternatives_text(const Key& key) {
  std::vector<std::string> groups;
  bool single = true;
  for (const auto& group : key.alternatives) {
    groups.push_back(listing(group, "and"));
    single = single && group.size() == 1;
  }
  if (key.alternatives.size() == 1) return "at least one of " + listing(key.alternatives[0]);
  return single ? "exactly one of " + listing(groups) : "either some of " + listing(groups, "or else");
}

}  // namespace

std::vector<DescribedKey> every_key(const Schema& schema) {
  Walker walker(&schema);
  walker.enter(schema.root(), "", "");
  return walker.found;
}

std::vector<DescribedKey> keys_inside(const Key& key) {
  Walker walker(nullptr);
  walker.enter(key, "", "");
  return walker.found;
}

std::string type_text(const Key& use, const Schema& schema) {
  const Key& key = schema.structure(use);
  switch (key.type) {
    case Type::number:
      return "number";
    case Type::integer:
      return "whole number";
    case Type::boolean:
      return "true or false";
    case Type::text:
      return "text";
    case Type::word:
      return "one of " + listing(key.words);
    case Type::path:
      return "file name";
    case Type::expression:
      return "number or formula";
    case Type::point:
      return "point: 3 numbers, in 2-D 2";
    case Type::list: {
      const Key& element = key.element.at(0);
      if (!element.reference.empty()) return fmt::format("list of {}s", element.reference);
      const std::string what =
          element.type == Type::map || element.type == Type::choice ? "maps" : type_text(element, schema);
      const std::string inner = element.alternatives.empty() ? "" : ", each with " + alternatives_text(element);
      return fmt::format("list of {}{}", what == "maps" ? "maps" : "entries, each " + what, inner);
    }
    case Type::named: {
      const Key& element = key.element.at(0);
      if (element.type != Type::map && element.type != Type::choice)
        return fmt::format("map from names to {}s", type_text(element, schema));
      return "map from names to maps" +
             (element.alternatives.empty() ? "" : ", each with " + alternatives_text(element));
    }
    case Type::map:
    case Type::choice:
      break;
  }
  return key.alternatives.empty() ? "map" : "map with " + alternatives_text(key);
}

std::string unit_text(const std::string& unit) { return unit == "-" ? "dimensionless" : unit; }

std::string default_text(const DescribedKey& described) {
  const Key& key = *described.key;
  if (key.required) return "required";
  if (described.alternative) return "alternative";
  if (!key.fallback) return "optional";
  return *key.fallback == "{}" || *key.fallback == "[]" ? "optional" : *key.fallback;
}

bool is_alternative(const Key& map, const Key& key) {
  if (map.alternatives.size() < 2) return false;
  return std::any_of(map.alternatives.begin(), map.alternatives.end(),
                     [&](const auto& group) { return std::count(group.begin(), group.end(), key.name) > 0; });
}

std::string help_text(const DescribedKey& described, const Schema& schema) {
  const Key& key = *described.key;
  std::string out = fmt::format("{}\n  {}\n", described.path, key.sentence);
  out += fmt::format("  type: {}\n", type_text(key, schema));
  if (!key.unit.empty()) out += fmt::format("  unit: {}\n", unit_text(key.unit));
  const std::string fallback = default_text(described);
  out += key.fallback && fallback != "optional" ? fmt::format("  default: {}\n", fallback)
                                                : fmt::format("  {}\n", fallback);
  if (!range_text(key).empty()) out += fmt::format("  range: {}\n", range_text(key));

  const Key* holder = &schema.structure(key);
  while (!holder->element.empty() && holder->element[0].reference.empty()) holder = &holder->element[0];
  if (!holder->keys.empty()) out += "  keys:\n";
  std::size_t width = 0;
  for (const std::string& name : names_of(holder->keys)) width = std::max(width, name.size());
  for (const Key& inner : holder->keys) {
    out += fmt::format("    {:<{}}  {} ({})\n", inner.name, width, inner.sentence,
                       default_text({"", "", &inner, is_alternative(*holder, inner)}));
  }
  if (holder->names_field) {
    out += "  fields:\n";
    for (const FieldDeclaration& field : schema.fields()) width = std::max(width, field.name.size());
    for (const FieldDeclaration& field : schema.fields())
      out += fmt::format("    {:<{}}  {}\n", field.name, width, field.sentence);
  }
  if (holder->picks_model) {
    for (const ModelDeclaration& model : schema.models()) {
      out += fmt::format("    with model {} also: {}\n", model.name, listing(names_of(model.keys), "and"));
    }
  }
  if (!key.example.empty()) {
    out += "  example:\n    ";
    for (const char c : key.example) out += c == '\n' ? std::string("\n    ") : std::string(1, c);
    out += "\n";
  }
  return out;
}

std::string field_text(const FieldDeclaration& field) {
  return fmt::format(
      "{}, an output field\n  {}\n  unit: {}\n  values a particle: {}\n  exists: {}\n  asked for with output: "
      "{{fields: [{}]}}\n",
      field.name, field.sentence, unit_text(field.unit), field.components, field.exists, field.name);
}

}  // namespace perinox::deck
