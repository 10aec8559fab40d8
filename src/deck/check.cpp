#include "check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "foreign_words.hpp"
#include "perinox/deck/scalar.hpp"
#include "remedies.hpp"

namespace perinox::deck {
namespace {

std::vector<std::string> names_of(const std::vector<Key>& keys) {
  std::vector<std::string> names;
  for (const Key& key : keys) names.push_back(key.name);
  return names;
}

class Checker {
 public:
  Checker(const Schema& schema, InputFiles files, const Node& root) : schema_(schema), files_(std::move(files)) {
    const Node* dimension = root.find("dimension");
    in_plane_ = dimension != nullptr && dimension->text != "3";
  }

  /// Checks one value. Messages call it `name`; `path` is its dotted path.
  Value check(const Node& node, const Key& use, const std::string& name, const std::string& path) {
    const Key& key = schema_.structure(use);
    if (node.kind == Node::Kind::null) {
      refuse(node.location,
             fmt::format("{} has no value; give it {}{}", name, expected(key), use.required ? "" : " or remove it"));
    }
    const bool wants_list = key.type == Type::list || key.type == Type::point;
    const bool wants_map = key.type == Type::map || key.type == Type::choice || key.type == Type::named;
    const Node::Kind wanted = wants_list ? Node::Kind::list : wants_map ? Node::Kind::map : Node::Kind::scalar;
    if (node.kind != wanted) {
      refuse(node.location, fmt::format("{} must be {}, but {} was found{}", name, expected(key), node.description(),
                                        right_form(node, key, schema_)));
    }
    switch (key.type) {
      case Type::list:
        return check_list(node, key, name, path);
      case Type::point:
        return check_point(node, key, name);
      case Type::named:
        return check_named(node, key, path);
      case Type::map:
      case Type::choice:
        return check_map(node, key, path);
      default:
        if (key.names_field) refuse_unknown_field(node);
        return check_scalar(node, key, name, files_);
    }
  }

 private:
  /// Refuses an unknown field. A field that only other scenes have is not offered as a remedy.
  void refuse_unknown_field(const Node& node) const {
    if (schema_.field(node.text) != nullptr) return;
    std::vector<std::string> names;
    for (const FieldDeclaration& field : schema_.fields())
      if (!field.plane_only || in_plane_) names.push_back(field.name);
    const std::string own_word = own_word_for(node.text, names);
    const std::string hint = own_word.empty() ? did_you_mean(node.text, names) : "; did you mean " + own_word + "?";
    refuse(node.location, fmt::format("there is no output field '{}'{}", node.text,
                                      hint.empty() ? "; there is " + listing(names, "and") : hint));
  }

  Value check_list(const Node& node, const Key& key, const std::string& name, const std::string& path) {
    if (node.items.size() < key.minimum_items) {
      refuse(node.location, fmt::format("{} needs at least {} {}, but has {}", name, key.minimum_items,
                                        key.minimum_items == 1 ? "entry" : "entries", node.items.size()));
    }
    std::vector<Value> items;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      items.push_back(check(node.items[i], key.element.at(0), "an entry of " + name, fmt::format("{}.{}", path, i)));
      if (key.unique && !seen.insert(items.back().text()).second) {
        refuse(node.items[i].location, fmt::format("{} is named twice in {}; remove one", items.back().text(), name));
      }
    }
    return Value::list(std::move(items), node.location, true);
  }

  Value check_point(const Node& node, const Key& key, const std::string& name) {
    if (node.items.size() != 2 && node.items.size() != 3) {
      const bool one = node.items.size() == 1 && node.items[0].kind == Node::Kind::scalar;
      refuse(node.location, fmt::format("{} must be a list of 3 numbers, or 2 in 2-D, but has {}{}", name,
                                        node.items.size(), one ? right_form(node.items[0], key, schema_) : ""));
    }
    Key coordinate;
    coordinate.type = Type::number;
    coordinate.unit = key.unit;
    std::vector<Value> items;
    for (const Node& item : node.items) items.push_back(check(item, coordinate, "an entry of " + name, ""));
    return Value::list(std::move(items), node.location, true);
  }

  Value check_named(const Node& node, const Key& key, const std::string& path) {
    refuse_duplicates(node, key.name);
    std::vector<std::pair<std::string, Value>> entries;
    for (const Entry& entry : node.entries) {
      Node value = entry.value;
      if (value.kind == Node::Kind::null) value.location = entry.location;
      const std::string inner = path + "." + entry.key;
      entries.emplace_back(entry.key, check(value, key.element.at(0), inner, inner));
    }
    return Value::map(std::move(entries), node.location, true);
  }

  Value check_map(const Node& node, const Key& key, const std::string& path) {
    const std::string place = key.place.empty() ? path : key.place;
    std::vector<Key> of_material;
    if (key.picks_model) of_material = keys_of_material(node, key, path);
    const std::vector<Key>& keys = key.picks_model ? of_material : key.keys;
    const std::string model = key.picks_model ? node.find("model")->text : "";
    refuse_unknown(node, keys, place, model);
    refuse_duplicates(node, place);
    refuse_alternatives(node, key, place);
    for (const Key& inner : keys) {
      if (inner.required && node.find(inner.name) == nullptr) missing(node, inner, place);
    }
    std::vector<std::pair<std::string, Value>> entries;
    for (const Key& inner : keys) {
      const std::string inner_path = path.empty() ? inner.name : path + "." + inner.name;
      const Node* value = node.find(inner.name);
      entries.emplace_back(inner.name, value != nullptr ? check(*value, inner, inner.name, inner_path)
                                                        : fallback(inner, inner_path, node.location));
    }
    return Value::map(std::move(entries), node.location, true);
  }

  /// The keys common to all materials and those of the model that the node names.
  std::vector<Key> keys_of_material(const Node& node, const Key& key, const std::string& path) {
    const Node* name = node.find("model");
    const Key& model_key = key.keys.at(0);
    if (name == nullptr) {
      for (const Entry& entry : node.entries) {
        if (nearest_is(entry.key, "model")) {
          refuse(entry.location, fmt::format("{} is not a key of {}; did you mean model?", entry.key, key.place));
        }
      }
      missing(node, model_key, key.place);
    }
    const Value word = check(*name, model_key, "model", path + ".model");
    const ModelDeclaration* model = schema_.model(word.text());
    if (model == nullptr) throw std::logic_error("the schema has no model " + word.text());
    std::vector<Key> keys = key.keys;
    for (const Key& own : model->keys) {
      const auto same = [&](const Key& common) { return common.name == own.name; };
      const auto found = std::find_if(keys.begin(), keys.end(), same);
      if (found == keys.end()) {
        keys.push_back(own);
      } else {
        *found = own;
      }
    }
    return keys;
  }

  static bool nearest_is(const std::string& word, const std::string& name) {
    return did_you_mean(word, {name}) == "; did you mean " + name + "?";
  }

  void refuse_unknown(const Node& node, const std::vector<Key>& keys, const std::string& place,
                      const std::string& model) {
    const std::vector<std::string> known = names_of(keys);
    for (const Entry& entry : node.entries) {
      if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
      std::vector<std::string> others;
      for (const ModelDeclaration& other : schema_.models()) {
        const std::vector<std::string> names = names_of(other.keys);
        if (!model.empty() && std::find(names.begin(), names.end(), entry.key) != names.end())
          others.push_back(other.name);
      }
      const std::string hint = others.empty()
                                   ? right_key(node, entry, known, schema_)
                                   : fmt::format(" of the model {}; it is one of {}", model, listing(others, "and"));
      refuse(entry.location, fmt::format("{} is not a key of {}{}", entry.key, place, hint));
    }
  }

  static void refuse_duplicates(const Node& node, const std::string& place) {
    std::map<std::string, int> lines;
    for (const Entry& entry : node.entries) {
      const auto [first, fresh] = lines.emplace(entry.key, entry.location.line);
      if (fresh) continue;
      refuse(entry.location,
             fmt::format("{} is written twice in {} (first at line {}); remove one", entry.key, place, first->second));
    }
  }

  static void refuse_alternatives(const Node& node, const Key& key, const std::string& place) {
    if (key.alternatives.empty()) return;
    std::vector<const std::vector<std::string>*> used;
    std::vector<std::string> all, found;
    Location second = node.location;
    for (const auto& group : key.alternatives) {
      all.insert(all.end(), group.begin(), group.end());
      const auto written = [&](const std::string& name) { return node.find(name) != nullptr; };
      const auto first = std::find_if(group.begin(), group.end(), written);
      if (first == group.end()) continue;
      used.push_back(&group);
      found.push_back(*first);
    }
    const bool single_words = std::all_of(key.alternatives.begin(), key.alternatives.end(),
                                          [](const auto& group) { return group.size() == 1; });
    if (used.empty()) {
      refuse(node.location, single_words && all.size() > 1
                                ? fmt::format("{} needs exactly one of {}, but has none", place, listing(all))
                                : fmt::format("{} is empty; it needs {}", place, listing(all)));
    }
    if (used.size() == 1) return;
    for (const Entry& entry : node.entries) {
      if (std::find(found.begin(), found.end(), entry.key) != found.end()) second = entry.location;
    }
    refuse(second, fmt::format("{} has {}{}, but these exclude each other; keep one", place,
                               found.size() == 2 ? "both " : "", listing(found, "and")));
  }

  [[noreturn]] void missing(const Node& node, const Key& key, const std::string& place) {
    refuse(node.location, fmt::format("{} needs the key {} ({}): {}", place, key.name, expected(schema_.structure(key)),
                                      key.sentence));
  }

  /// A default's text as a tree, parsed once. There are few of them, and every deck needs most.
  static const Node& parsed_default(const std::string& text) {
    static std::map<std::string, Node> parsed;
    const auto found = parsed.find(text);
    return found != parsed.end() ? found->second : parsed.emplace(text, parse_yaml(text, "")).first->second;
  }

  /// The default of a key that was not written. It is a Value of kind none if the key has none.
  Value fallback(const Key& key, const std::string& path, const Location& where) {
    if (!key.fallback) return {};
    try {
      const Node& node = parsed_default(*key.fallback);
      if (node.kind == Node::Kind::map && node.entries.empty() && key.type == Type::map) {
        return relocated(check_map(node, schema_.structure(key), path), where);
      }
      return relocated(check(node, key, key.name, path), where);
    } catch (const std::runtime_error& error) {
      throw std::logic_error("the schema's default of " + path + " is not valid: " + error.what());
    }
  }

  /// The same value, marked as a default of the map at `where`.
  static Value relocated(const Value& value, const Location& where) {
    if (value.kind() == Value::Kind::scalar) return Value::scalar(value.text(), where, false);
    if (value.kind() == Value::Kind::list) {
      std::vector<Value> items;
      for (const Value& item : value.items()) items.push_back(relocated(item, where));
      return Value::list(std::move(items), where, false);
    }
    if (value.kind() == Value::Kind::none) return {};
    std::vector<std::pair<std::string, Value>> entries;
    for (const auto& entry : value.entries()) entries.emplace_back(entry.first, relocated(entry.second, where));
    for (const auto& key : value.absent_keys()) entries.emplace_back(key, Value());
    return Value::map(std::move(entries), where, false);
  }

  const Schema& schema_;
  InputFiles files_;
  bool in_plane_ = false;
};

}  // namespace

Value check_against_schema(const Node& root, const Schema& schema, const InputFiles& files) {
  return Checker(schema, files, root).check(root, schema.root(), "the deck", "");
}

Value check_against_key(const Node& root, const Key& key, const std::string& name, const InputFiles& files) {
  static const Schema without_models({});
  return Checker(without_models, files, root).check(root, key, name, "");
}

std::string expected(const Key& key) {
  switch (key.type) {
    case Type::number:
      return "a number";
    case Type::integer:
      return "a whole number";
    case Type::boolean:
      return "true or false";
    case Type::text:
      return "a text";
    case Type::word:
      return key.words.empty() ? "a word" : "one of " + listing(key.words);
    case Type::path:
      return "a file name";
    case Type::expression:
      return "a number or a formula";
    case Type::point:
      return "a list of 3 numbers, or 2 in 2-D";
    case Type::list:
      return "a list";
    case Type::named:
      return "a map from names of your choice";
    case Type::map:
      return "a map with the keys " + listing(names_of(key.keys), "and");
    case Type::choice:
      return "a map with exactly one of " + listing(names_of(key.keys));
  }
  return "a value";
}

std::string range_text(const Key& key) {
  std::string low, high;
  if (key.minimum)
    low = fmt::format("{} {}", key.exclusive_minimum ? "greater than" : "at least", format_number(*key.minimum));
  if (key.maximum) high = fmt::format("at most {}", format_number(*key.maximum));
  if (!low.empty() && !high.empty()) return low + " and " + high;
  return low + high;
}

}  // namespace perinox::deck
