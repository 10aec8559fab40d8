#include "json.hpp"

#include "perinox/deck/scalar.hpp"

namespace perinox::deck {

Json Json::literal(std::string text) {
  Json json;
  json.text_ = std::move(text);
  return json;
}

Json Json::text(const std::string& text) { return literal(quote(text)); }

Json Json::texts(const std::vector<std::string>& words) {
  Json json = array();
  for (const std::string& word : words) json.add(text(word));
  return json;
}

Json Json::array(std::vector<Json> items) {
  Json json;
  json.kind_ = Kind::array;
  for (Json& item : items) json.add(std::move(item));
  return json;
}

Json Json::object() {
  Json json;
  json.kind_ = Kind::object;
  return json;
}

Json& Json::set(const std::string& key, Json value) {
  entries_.emplace_back(key, std::move(value));
  return *this;
}

Json& Json::set_first(const std::string& key, Json value) {
  entries_.insert(entries_.begin(), {key, std::move(value)});
  return *this;
}

Json& Json::add(Json value) {
  entries_.emplace_back("", std::move(value));
  return *this;
}

std::string Json::dump(std::size_t indent) const {
  if (kind_ == Kind::literal) return text_;
  const bool object = kind_ == Kind::object;
  bool one_line = !object;
  for (const auto& entry : entries_) one_line = one_line && entry.second.kind_ == Kind::literal;
  if (entries_.empty()) return object ? "{}" : "[]";
  std::string out(1, object ? '{' : '[');
  const std::string line = one_line ? "" : "\n" + std::string(indent + 2, ' ');
  bool first = true;
  for (const auto& [key, value] : entries_) {
    if (!first) out += one_line ? ", " : ",";
    first = false;
    out += line;
    if (object) out += quote(key) + ": ";
    out += value.dump(indent + 2);
  }
  if (!one_line) out += "\n" + std::string(indent, ' ');
  return out + (object ? "}" : "]");
}

}  // namespace perinox::deck
