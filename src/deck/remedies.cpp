#include "remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "describe.hpp"
#include "foreign_words.hpp"
#include "perinox/deck/expression.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/deck/scalar.hpp"

namespace perinox::deck {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::vector<std::string> words_between_blanks(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != ';')
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

/// A scalar as it would be written as a value of this key; "" if the key does not take it.
std::string as_value_of(const Node& scalar, const Key& key) {
  const bool number = parse_number(scalar.text).has_value();
  switch (key.type) {
    case Type::number:
      return number ? scalar.text : "";
    case Type::integer:
      return parse_integer(scalar.text) ? scalar.text : "";
    case Type::expression: {
      const bool formula = scalar.text.find_first_of("<>=*+/^(") != std::string::npos;
      return number ? scalar.text : formula ? quote(scalar.text) : "";
    }
    case Type::word:
      return std::count(key.words.begin(), key.words.end(), scalar.text) > 0 ? scalar.text : "";
    case Type::text:
      return number || scalar.text.find_first_of("<>=*+/^(") != std::string::npos ? "" : quote_if_needed(scalar.text);
    case Type::path:
      return scalar.text.find('.') != std::string::npos && !number ? quote_if_needed(scalar.text) : "";
    default:
      return "";
  }
}

/// The remedy for `box` or 3.015 where a map is wanted: {box: ...}, {ratio: 3.015}.
std::string map_of_scalar(const Node& scalar, const Key& wanted, const Schema& schema) {
  if (&wanted == &schema.root()) return "";
  std::vector<std::string> written;
  for (const Key& use : wanted.keys) {
    const Key& key = schema.structure(use);
    if (scalar.text == use.name) {
      std::vector<std::string> inner;
      for (const Key& one : key.keys) inner.push_back(one.name + ": ...");
      return fmt::format("; write {{{}: {}}}", use.name,
                         inner.empty() ? "..." : "{" + fmt::format("{}", fmt::join(inner, ", ")) + "}");
    }
    const std::string value = as_value_of(scalar, key);
    if (!value.empty() && written.size() < 3) written.push_back(fmt::format("{{{}: {}}}", use.name, value));
  }
  if (wanted.picks_model && schema.model(scalar.text) != nullptr)
    return fmt::format("; write {{model: {}, ...}}", scalar.text);
  return written.empty() ? "" : "; write " + listing(written);
}

std::string written_list(const Node& list, std::size_t begin, std::size_t end) {
  std::vector<std::string> texts;
  for (std::size_t k = begin; k < end; ++k) texts.push_back(list.items[k].text);
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

/// The remedy for [0, 0, 1] where a map of components is wanted: {x: 0, y: 0, z: 1}.
std::string map_of_list(const Node& list, const Key& wanted, const Schema& schema) {
  if (wanted.type == Type::named) return "; take the hyphens away and write each entry under its name: NAME: {...}";
  const bool components = wanted.keys.size() >= 3 && wanted.keys[0].name == "x" && wanted.keys[2].name == "z";
  const bool scalars = std::all_of(list.items.begin(), list.items.end(),
                                   [](const Node& item) { return item.kind == Node::Kind::scalar; });
  if (components && scalars && (list.items.size() == 2 || list.items.size() == 3)) {
    std::vector<std::string> written;
    for (std::size_t c = 0; c < list.items.size(); ++c) {
      const std::string value = as_value_of(list.items[c], wanted.keys[c]);
      if (value.empty()) return "";
      written.push_back(wanted.keys[c].name + ": " + value);
    }
    return fmt::format("; write {{{}}}", fmt::join(written, ", "));
  }
  const std::size_t half = list.items.size() / 2;
  if (scalars && wanted.keys.size() == 2 && wanted.keys[0].name == "min" && 2 * half == list.items.size() &&
      (half == 2 || half == 3))
    return fmt::format("; write {{min: {}, max: {}}}", written_list(list, 0, half), written_list(list, half, 2 * half));
  for (const Key& key : wanted.keys)
    if (scalars && key.type == Type::list && !list.items.empty() && !as_value_of(list.items[0], key.element[0]).empty())
      return fmt::format("; write {{{}: {}}}", key.name, written_list(list, 0, list.items.size()));
  if (scalars && list.items.size() == 1) return map_of_scalar(list.items[0], wanted, schema);
  const bool of_one_map = list.items.size() == 1 && list.items[0].kind == Node::Kind::map;
  return of_one_map ? "; there is one only: take the hyphen or the brackets away" : "";
}

std::string list_of(const Node& found, const Key& wanted, const Schema& schema) {
  if (wanted.type == Type::point && found.kind == Node::Kind::map) return "; write the coordinates as [0, 0, 0]";
  if (wanted.type == Type::point) {
    const std::vector<std::string> numbers = words_between_blanks(found.text);
    const bool all =
        std::all_of(numbers.begin(), numbers.end(), [](const std::string& one) { return parse_number(one); });
    return all && (numbers.size() == 2 || numbers.size() == 3) ? fmt::format("; write [{}]", fmt::join(numbers, ", "))
                                                               : "";
  }
  const Key& element = schema.structure(wanted.element.at(0));
  const bool of_maps = element.type == Type::map || element.type == Type::choice;
  if (found.kind == Node::Kind::map) return of_maps ? "; begin each entry of the list with a hyphen and a blank" : "";
  const std::string value = as_value_of(found, element);
  return value.empty() ? "" : fmt::format("; write [{}]", value);
}

/// The digits of a text in groups of three, such as 160,000 or 1 000 000; "" for any other text.
std::string without_groups(const std::string& text) {
  const std::size_t first = text.find_first_of(", _'");
  if (first == std::string::npos || first == 0 || first > 3) return "";
  std::string digits = text.substr(0, first);
  for (std::size_t k = first; k < text.size(); k += 4) {
    if (text[k] != text[first] || text.size() < k + 4) return "";
    digits += text.substr(k + 1, 3);
  }
  return std::all_of(digits.begin(), digits.end(), is_digit) ? digits : "";
}

/// The value of a formula of numbers alone, such as 1/3; nothing for anything else.
std::optional<double> constant_value(const std::string& text) {
  if (text.find_first_of("+-*/^()") == std::string::npos) return std::nullopt;
  try {
    const Expression formula(text, {});
    const double value = formula(1, 2, 3, 4);
    const bool constant = value == formula(-7, 11, 0.3, 9);
    return constant && value - value == 0 ? std::optional<double>(value) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// The number with which a text such as "10 mm" begins, if letters or % follow it. `rest`: what follows.
std::string number_before(const std::string& text, std::string& rest) {
  for (std::size_t end = text.size(); end > 0; --end) {
    if (!is_digit(text[end - 1]) && text[end - 1] != '.') continue;
    if (!parse_number(text.substr(0, end))) continue;
    const std::size_t letter = text.find_first_not_of(" \t", end);
    if (letter == std::string::npos) return "";
    rest = text.substr(letter);
    const bool unit = std::isalpha(static_cast<unsigned char>(rest[0])) || rest[0] == '%' || rest[0] == '\xC2' ||
                      rest.rfind("//", 0) == 0;
    return unit ? text.substr(0, end) : "";
  }
  return "";
}

}  // namespace

std::string right_form(const Node& found, const Key& wanted, const Schema& schema) {
  if (wanted.type == Type::list || wanted.type == Type::point) return list_of(found, wanted, schema);
  if (wanted.type == Type::map || wanted.type == Type::choice || wanted.type == Type::named) {
    if (found.kind == Node::Kind::list) return map_of_list(found, wanted, schema);
    return wanted.type == Type::named ? "" : map_of_scalar(found, wanted, schema);
  }
  const bool name = wanted.type == Type::text || wanted.type == Type::word;
  if (name && found.kind == Node::Kind::list && found.items.size() > 1) return "; only one is taken here";
  if (found.kind != Node::Kind::list || found.items.size() != 1 || found.items[0].kind != Node::Kind::scalar) return "";
  const std::string value = as_value_of(found.items[0], wanted);
  return value.empty() ? "" : "; write " + value + " without brackets or hyphen";
}

std::string right_number(const Node& found) {
  const std::string& text = found.text;
  const std::string digits = without_groups(text);
  const bool comma = text.find(',') != std::string::npos;
  std::string decimal = text;
  for (char& c : decimal) {
    if (c == ',') c = '.';
    if (c == 'd' || c == 'D') c = 'e';
  }
  const bool reads = decimal != text && parse_number(decimal);
  if (!digits.empty() && comma && reads)
    return fmt::format("; write {}, or {} if the comma is a decimal one", digits, decimal);
  if (!digits.empty()) return "; write " + digits;
  if (reads) return "; write " + decimal;
  std::string rest;
  const std::string number = number_before(text, rest);
  if (!number.empty() && rest.rfind("//", 0) == 0) return "; write " + number + ", and # before a comment";
  if (!number.empty() && rest == "%") return "; write " + format_number(*parse_number(number + "e-2"));
  if (!number.empty())
    return fmt::format("; write {}: a number has no unit here, all are in the one set of units that the deck is in",
                       number);
  if (const auto value = constant_value(text))
    return "; formulas are read in loads and sets only, so write " + format_number(*value);
  return "";
}

std::string right_key(const Node& map, const Entry& entry, const std::vector<std::string>& known,
                      const Schema& schema) {
  const auto is_known = [&](const std::string& word) { return std::count(known.begin(), known.end(), word) > 0; };
  const std::size_t end = std::min(entry.key.find_first_of(": =\t"), entry.key.size());
  const std::string word = entry.key.substr(0, end);
  if (end < entry.key.size() && is_known(word)) {
    const std::size_t value = entry.key.find_first_not_of(": =\t", end);
    const bool whole = value != std::string::npos && entry.value.kind == Node::Kind::null;
    return fmt::format("; a colon and a blank belong between {} and its value{}", word,
                       whole ? ": " + word + ": " + entry.key.substr(value) : "");
  }
  const Entry* before = nullptr;
  for (const Entry& other : map.entries) {
    if (&other == &entry) break;
    before = &other;
  }
  if (before != nullptr && before->value.kind == Node::Kind::null && is_known(before->key))
    return fmt::format("; if it belongs into {} above it, indent it further", before->key);
  if (before != nullptr && entry.value.kind == Node::Kind::null && before->value.kind == Node::Kind::scalar &&
      is_known(before->key))
    return fmt::format("; the entries of a list stand in brackets, as in {}: [{}, {}]", before->key, before->value.text,
                       entry.key);
  const std::string own_word = own_word_for(entry.key, known);
  if (!own_word.empty()) return "; did you mean " + own_word + "?";
  const std::string near = did_you_mean(entry.key, known);
  if (!near.empty()) return near;
  if (schema.models().empty()) return "; its keys are " + listing(known, "and");  // of a file that is no deck
  const std::string advice = advice_on(entry.key);
  if (!advice.empty()) return "; " + advice;
  std::vector<std::string> places;
  for (const DescribedKey& described : every_key(schema)) {
    const std::string& path = described.path_without_model;
    if (path == entry.key) return "; it is a key of the deck itself, so let it begin in the first column";
    if (described.key->name != entry.key) continue;
    if (std::count(places.begin(), places.end(), path) == 0) places.push_back(path);
  }
  if (places.size() == 1) return "; it belongs elsewhere, as " + places[0];
  return "; its keys are " + listing(known, "and");
}

}  // namespace perinox::deck
