#include "declare.hpp"

#include "words.hpp"

namespace perinox::deck {
namespace {

Key key_of(Type type, std::string name, std::string unit, std::string sentence) {
  Key key;
  key.name = std::move(name);
  key.type = type;
  key.unit = std::move(unit);
  key.sentence = std::move(sentence);
  return key;
}

}  // namespace

Key number_key(std::string name, std::string unit, std::string sentence) {
  return key_of(Type::number, std::move(name), std::move(unit), std::move(sentence));
}

Key positive_key(std::string name, std::string unit, std::string sentence) {
  Key key = number_key(std::move(name), std::move(unit), std::move(sentence));
  key.minimum = 0;
  key.exclusive_minimum = true;
  return key;
}

Key integer_key(std::string name, double minimum, double maximum, std::string fallback, std::string sentence) {
  Key key = key_of(Type::integer, std::move(name), "-", std::move(sentence));
  key.minimum = minimum;
  key.maximum = maximum;
  if (!fallback.empty()) key.fallback = std::move(fallback);
  return key;
}

Key word_key(std::string name, std::vector<std::string> words, std::string fallback, std::string sentence) {
  Key key = key_of(Type::word, std::move(name), "", std::move(sentence));
  key.words = std::move(words);
  if (!fallback.empty()) key.fallback = std::move(fallback);
  return key;
}

Key text_key(std::string name, std::string sentence) {
  return key_of(Type::text, std::move(name), "", std::move(sentence));
}

Key boolean_key(std::string name, bool fallback, std::string sentence) {
  Key key = key_of(Type::boolean, std::move(name), "", std::move(sentence));
  key.fallback = fallback ? "true" : "false";
  return key;
}

Key point_key(std::string name, std::string unit, std::string sentence) {
  return required(key_of(Type::point, std::move(name), std::move(unit), std::move(sentence)));
}

Key expression_key(std::string name, std::string unit, std::string sentence) {
  return key_of(Type::expression, std::move(name), std::move(unit), std::move(sentence));
}

Key path_key(std::string name, std::string sentence) {
  return key_of(Type::path, std::move(name), "", std::move(sentence));
}

Key map_key(std::string name, std::string sentence, std::vector<Key> keys) {
  Key key = key_of(Type::map, std::move(name), "", std::move(sentence));
  key.keys = std::move(keys);
  return key;
}

Key choice_key(std::string name, std::string sentence, std::vector<Key> keys) {
  Key key = key_of(Type::choice, std::move(name), "", std::move(sentence));
  for (const Key& alternative : keys) key.alternatives.push_back({alternative.name});
  key.keys = std::move(keys);
  return key;
}

Key list_key(std::string name, std::string sentence, Key element) {
  Key key = key_of(Type::list, std::move(name), "", std::move(sentence));
  key.element.push_back(std::move(element));
  return key;
}

Key required(Key key) {
  key.required = true;
  return key;
}

}  // namespace perinox::deck
