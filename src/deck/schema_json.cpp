/// Writes the schema as JSON Schema, draft 7, for editors that complete and check YAML while it is written.
#include <algorithm>

#include "check.hpp"
#include "document.hpp"
#include "json.hpp"
#include "perinox/deck/scalar.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {
namespace {

Json json_of(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return Json::literal("null");
    case Node::Kind::scalar: {
      const bool bare = !node.quoted && (node.text == "true" || node.text == "false" || parse_number(node.text));
      return bare ? Json::literal(node.text) : Json::text(node.text);
    }
    case Node::Kind::list: {
      Json list = Json::array();
      for (const Node& item : node.items) list.add(json_of(item));
      return list;
    }
    case Node::Kind::map:
      break;
  }
  Json map = Json::object();
  for (const Entry& entry : node.entries) map.set(entry.key, json_of(entry.value));
  return map;
}

class JsonWriter {
 public:
  explicit JsonWriter(const Schema& schema) : schema_(schema) {}

  Json write(const Key& key) const {
    if (!key.reference.empty()) return Json::object().set("$ref", Json::text("#/definitions/" + key.reference));
    Json json = key.picks_model ? write_model_choice(key) : write_type(key);
    std::string sentence = key.sentence;
    if (!key.unit.empty() && key.unit != "-" && key.unit != "dimensionless") sentence += " Unit: " + key.unit + ".";
    if (!sentence.empty()) json.set("description", Json::text(sentence));
    if (key.fallback) json.set("default", json_of(parse_yaml(*key.fallback, "")));
    return json;
  }

 private:
  static Json type(const char* name) { return Json::object().set("type", Json::text(name)); }

  Json write_type(const Key& key) const {
    switch (key.type) {
      case Type::number:
        return with_range(type("number"), key);
      case Type::integer:
        return with_range(type("integer"), key);
      case Type::boolean:
        return type("boolean");
      case Type::text:
        return Json::object().set("type", Json::texts({"string", "number", "boolean"}));
      case Type::path:
        return type("string");
      case Type::expression:
        return Json::object().set("type", Json::texts({"number", "string"}));
      case Type::word:
        return Json::object().set("enum", words_of(key));
      case Type::point:
        return type("array")
            .set("items", type("number"))
            .set("minItems", Json::literal("2"))
            .set("maxItems", Json::literal("3"));
      case Type::list: {
        Json json = type("array");
        json.set("items", write(key.element.at(0)));
        if (key.minimum_items > 0) json.set("minItems", Json::literal(std::to_string(key.minimum_items)));
        if (key.unique) json.set("uniqueItems", Json::literal("true"));
        return json;
      }
      case Type::named:
        return type("object").set("additionalProperties", write(key.element.at(0)));
      case Type::map:
      case Type::choice:
        break;
    }
    return write_map(key.keys, key.alternatives);
  }

  /// Allows words with and without quotes: a word that is a number (dimension: 3) is written without quotes in YAML.
  static Json words_of(const Key& key) {
    Json words = Json::array();
    for (const std::string& word : key.words) {
      if (parse_number(word)) words.add(Json::literal(word));
      words.add(Json::text(word));
    }
    return words;
  }

  static Json with_range(Json json, const Key& key) {
    if (key.minimum) {
      json.set(key.exclusive_minimum ? "exclusiveMinimum" : "minimum", Json::literal(format_number(*key.minimum)));
    }
    if (key.maximum) json.set("maximum", Json::literal(format_number(*key.maximum)));
    return json;
  }

  Json write_map(const std::vector<Key>& keys, const std::vector<std::vector<std::string>>& alternatives) const {
    Json json = type("object");
    Json properties = Json::object();
    std::vector<std::string> required;
    for (const Key& key : keys) {
      properties.set(key.name, write(key));
      if (key.required) required.push_back(key.name);
    }
    json.set("properties", properties).set("additionalProperties", Json::literal("false"));
    if (!required.empty()) json.set("required", Json::texts(required));
    if (alternatives.empty()) return json;
    Json groups = Json::array();
    for (const auto& group : alternatives) {
      Json any = Json::array();
      for (const std::string& name : group) any.add(Json::object().set("required", Json::texts({name})));
      groups.add(Json::object().set("anyOf", any));
    }
    return json.set("oneOf", groups);
  }

  /// Writes one alternative for each model, with `model` held to its name.
  Json write_model_choice(const Key& key) const {
    Json models = Json::array();
    for (const ModelDeclaration& model : schema_.models()) {
      std::vector<Key> keys = key.keys;
      for (const Key& own : model.keys) {
        const auto found =
            std::find_if(keys.begin(), keys.end(), [&](const Key& common) { return common.name == own.name; });
        if (found == keys.end()) {
          keys.push_back(own);
        } else {
          *found = own;
        }
      }
      keys.at(0).words = {model.name};
      models.add(write_map(keys, {}).set("title", Json::text(model.name)));
    }
    return Json::object().set("oneOf", models);
  }

  const Schema& schema_;
};

}  // namespace

std::string Schema::json_schema() const {
  const JsonWriter writer(*this);
  Json json = writer.write(root_);
  json.set_first("title", Json::text("perinox deck"));
  json.set_first("$schema", Json::text("http://json-schema.org/draft-07/schema#"));
  Json definitions = Json::object();
  for (const auto& [name, key] : definitions_) definitions.set(name, writer.write(key));
  json.set("definitions", definitions);
  return json.dump() + "\n";
}

}  // namespace perinox::deck
