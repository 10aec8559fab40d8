#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "check.hpp"
#include "mesh_file.hpp"
#include "perinox/deck/expression.hpp"
#include "perinox/deck/scalar.hpp"
#include "remedies.hpp"

namespace perinox::deck {
namespace {

bool is_infinite_or_nan(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '+' || c == '-' || c == '.'; }),
             text.end());
  return text == "nan" || text == "inf" || text == "infinity";
}

void check_range(double value, const std::string& text, const Key& key, const std::string& name,
                 const Location& where) {
  const bool low = key.minimum && (key.exclusive_minimum ? value <= *key.minimum : value < *key.minimum);
  const bool high = key.maximum && value > *key.maximum;
  if (low || high) refuse(where, fmt::format("{} is {} but must be {}", name, text, range_text(key)));
}

std::string check_number(const Node& node, const Key& key, const std::string& name) {
  const auto value = parse_number(node.text);
  if (value && !node.quoted) {
    check_range(*value, node.text, key, name, node.location);
    return format_number(*value);
  }
  if (value) refuse(node.location, fmt::format("{} must be a number; write {} without quotes", name, node.text));
  if (is_infinite_or_nan(node.text)) {
    refuse(node.location, fmt::format("{} must be a finite number, but '{}' was found", name, node.text));
  }
  const bool digits = !node.text.empty() && node.text.find_first_not_of("0123456789.eE+-") == std::string::npos &&
                      node.text.find_first_of("0123456789") != std::string::npos;
  refuse(node.location, fmt::format("{} must be a number{}, but '{}' was found{}", name,
                                    digits ? " that double precision can hold" : "", node.text, right_number(node)));
}

std::string check_integer(const Node& node, const Key& key, const std::string& name) {
  const auto value = parse_integer(node.text);
  if (value && !node.quoted) {
    check_range(static_cast<double>(*value), node.text, key, name, node.location);
    return std::to_string(*value);
  }
  if (value) refuse(node.location, fmt::format("{} must be a whole number; write {} without quotes", name, node.text));
  const auto number = parse_number(node.text);
  const bool whole =
      number && *number > -1e15 && *number < 1e15 && static_cast<double>(static_cast<long long>(*number)) == *number;
  const std::string hint = whole ? fmt::format("; write {}", static_cast<long long>(*number)) : right_number(node);
  refuse(node.location, fmt::format("{} must be a whole number, but '{}' was found{}", name, node.text, hint));
}

std::string check_boolean(const Node& node, const std::string& name) {
  if (!node.quoted && (node.text == "true" || node.text == "false")) return node.text;
  std::string lower = node.text;
  for (char& c : lower) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  const bool yes = lower == "true" || lower == "yes" || lower == "on" || lower == "1";
  const bool no = lower == "false" || lower == "no" || lower == "off" || lower == "0";
  refuse(node.location, fmt::format("{} must be true or false, but '{}' was found{}", name, node.text,
                                    yes  ? "; write true"
                                    : no ? "; write false"
                                         : ""));
}

std::string check_word(const Node& node, const Key& key, const std::string& name) {
  if (std::find(key.words.begin(), key.words.end(), node.text) != key.words.end()) return node.text;
  std::string hint = did_you_mean(node.text, key.words);
  if (hint.empty())
    hint = key.words.empty() ? "; there is nothing to choose from" : "; it can be " + listing(key.words);
  refuse(node.location, fmt::format("{} cannot be '{}'{}", name, node.text, hint));
}

std::string check_path(const Node& node, const Key& key, const std::string& name, const InputFiles& files) {
  if (node.text.empty()) refuse(node.location, fmt::format("{} must be a file name, but it is empty", name));
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path path = (fs::path(files.folder) / node.text).lexically_normal();
  if (files.may_be_gone) return path.string();
  if (!fs::exists(path, error)) {
    refuse(node.location, fmt::format("the file {} ({}) does not exist; relative names start at the deck's folder, so "
                                      "this one was looked for as {}",
                                      node.text, name, path.string()));
  }
  if (fs::is_directory(path, error)) {
    refuse(node.location, fmt::format("{} ({}) is a folder; name a file", path.string(), name));
  }
  // A device or a pipe may never end.
  if (!fs::is_regular_file(path, error)) {
    refuse(node.location, fmt::format("{} ({}) is neither a file nor a link to one; name a file", path.string(), name));
  }
  if (!std::ifstream(path)) {
    refuse(node.location, fmt::format("the file {} ({}) cannot be opened; check its permissions", path.string(), name));
  }
  const std::string mesh = mesh_format(path.string());
  if (!mesh.empty())
    refuse(node.location, fmt::format("the file {} ({}) is {}, and perinox reads no meshes; what is read here: {}",
                                      node.text, name, mesh, key.sentence));
  return path.string();
}

std::string check_expression(const Node& node, const std::string& name) {
  if (is_infinite_or_nan(node.text)) {
    refuse(node.location, fmt::format("{} must be a finite number or a formula, but '{}' was found", name, node.text));
  }
  const Expression expression(node.text, node.location);
  const auto number = parse_number(node.text);
  return number ? format_number(*number) : expression.text();
}

}  // namespace

Value check_scalar(const Node& node, const Key& key, const std::string& name, const InputFiles& files) {
  const bool one_word = key.type != Type::text && key.type != Type::path && key.type != Type::expression;
  if (one_word && node.goes_on.line > 0)
    refuse(node.goes_on,
           fmt::format("to YAML this line goes on with the value of {} in line {}, because it is indented "
                       "further and has no colon with a blank behind it; write it as KEY: VALUE, "
                       "indented as the other keys",
                       name, node.location.line));
  std::string text;
  switch (key.type) {
    case Type::number:
      text = check_number(node, key, name);
      break;
    case Type::integer:
      text = check_integer(node, key, name);
      break;
    case Type::boolean:
      text = check_boolean(node, name);
      break;
    case Type::word:
      text = check_word(node, key, name);
      break;
    case Type::path:
      return Value::file(check_path(node, key, name, files), node.text, node.location, true);
    case Type::expression:
      text = check_expression(node, name);
      break;
    case Type::text:
      if (node.text.empty()) refuse(node.location, fmt::format("{} is empty; give it a text", name));
      text = node.text;
      break;
    case Type::point:
    case Type::list:
    case Type::map:
    case Type::choice:
    case Type::named:
      throw std::logic_error("check_scalar was called for " + name + ", which is no scalar");
  }
  return Value::scalar(std::move(text), node.location, true);
}

}  // namespace perinox::deck
