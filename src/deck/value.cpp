#include "perinox/deck/value.hpp"

#include <algorithm>
#include <stdexcept>

#include "perinox/deck/scalar.hpp"

namespace perinox::deck {

struct Value::Data {
  Kind kind = Kind::none;
  Location location;
  bool given = false;
  std::string text;
  std::string written;  ///< an input file's name as the deck has it; otherwise empty
  std::vector<Value> items;
  std::vector<std::pair<std::string, Value>> entries;  ///< those with a value
  std::vector<std::pair<std::string, Value>> absent;   ///< optional keys that were not written
};

namespace {

[[noreturn]] void misused(const Location& where, const std::string& what) {
  throw std::logic_error(where.text() + ": " + what);
}

}  // namespace

Value::Value() : data_(std::make_shared<Data>()) {}

Value Value::scalar(std::string text, Location where, bool given) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::scalar;
  data->text = std::move(text);
  data->location = std::move(where);
  data->given = given;
  Value value;
  value.data_ = std::move(data);
  return value;
}

Value Value::file(std::string path, std::string written, Location where, bool given) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::scalar;
  data->text = std::move(path);
  data->written = std::move(written);
  data->location = std::move(where);
  data->given = given;
  Value value;
  value.data_ = std::move(data);
  return value;
}

Value Value::list(std::vector<Value> items, Location where, bool given) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::list;
  data->items = std::move(items);
  data->location = std::move(where);
  data->given = given;
  Value value;
  value.data_ = std::move(data);
  return value;
}

Value Value::map(std::vector<std::pair<std::string, Value>> entries, Location where, bool given) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::map;
  data->location = std::move(where);
  data->given = given;
  for (auto& entry : entries) {
    auto& destination = entry.second.kind() == Kind::none ? data->absent : data->entries;
    destination.push_back(std::move(entry));
  }
  Value value;
  value.data_ = std::move(data);
  return value;
}

Value::Kind Value::kind() const { return data_->kind; }
const Location& Value::location() const { return data_->location; }
bool Value::given() const { return data_->given; }

bool Value::has(const std::string& key) const {
  const auto& all = data_->entries;
  return std::any_of(all.begin(), all.end(), [&](const auto& entry) { return entry.first == key; });
}

const Value& Value::at(const std::string& key) const {
  for (const auto* list : {&data_->entries, &data_->absent}) {
    for (const auto& entry : *list) {
      if (entry.first == key) return entry.second;
    }
  }
  misused(location(), "the program asked for the key " + key + ", which the schema does not have here");
}

const std::vector<std::pair<std::string, Value>>& Value::entries() const { return data_->entries; }
std::vector<std::string> Value::absent_keys() const {
  std::vector<std::string> keys;
  for (const auto& entry : data_->absent) keys.push_back(entry.first);
  return keys;
}
const std::vector<Value>& Value::items() const { return data_->items; }

double Value::number() const {
  const auto value = parse_number(text());
  if (!value) misused(location(), "the program asked for a number where the deck has '" + text() + "'");
  return *value;
}

long long Value::integer() const {
  const auto value = parse_integer(text());
  if (!value) misused(location(), "the program asked for a whole number where the deck has '" + text() + "'");
  return *value;
}

bool Value::boolean() const {
  if (text() == "true") return true;
  if (text() == "false") return false;
  misused(location(), "the program asked for true or false where the deck has '" + text() + "'");
}

const std::string& Value::text() const {
  if (kind() != Kind::scalar) misused(location(), "the program asked for a scalar where the deck has none");
  return data_->text;
}

bool Value::is_file() const { return !data_->written.empty(); }

const std::string& Value::written() const {
  if (!is_file()) misused(location(), "the program asked for a file's name where the deck has none");
  return data_->written;
}

}  // namespace perinox::deck
