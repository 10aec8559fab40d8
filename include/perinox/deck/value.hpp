#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::deck {

/// A checked piece of a deck: a scalar, a list or a map, each with its place in the file. It is immutable after reading
/// and cheap to copy. Defaults have the location of the map into which they were filled.
class Value {
 public:
  enum class Kind { none, scalar, list, map };

  Kind kind() const;
  const Location& location() const;
  /// False if the schema's default was filled in.
  bool given() const;

  // The following members are for maps.
  /// True if the key has a value, written or by default. It is false for an optional key that was left out.
  bool has(const std::string& key) const;
  /// The value of a key. It is of kind `none` for an optional key that was left out. Throws std::logic_error for a key
  /// that the schema does not have, which is a fault of the program and not of the user.
  const Value& at(const std::string& key) const;
  /// The keys that have a value, in the schema's order. Names chosen by the user are in the file's order.
  const std::vector<std::pair<std::string, Value>>& entries() const;
  /// The optional keys that were left out and have no default.
  std::vector<std::string> absent_keys() const;
  // The following member is for lists.
  const std::vector<Value>& items() const;
  // The following members are for scalars, which have been checked against the schema's type.
  double number() const;
  long long integer() const;
  bool boolean() const;
  const std::string& text() const;
  /// True for the name of an input file. Its text() is the path that opens it.
  bool is_file() const;
  /// An input file's name as the deck has it. It counts from the deck's folder unless it is absolute.
  const std::string& written() const;

  Value();
  static Value scalar(std::string text, Location where, bool given);
  static Value file(std::string path, std::string written, Location where, bool given);
  static Value list(std::vector<Value> items, Location where, bool given);
  static Value map(std::vector<std::pair<std::string, Value>> entries, Location where, bool given);

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace perinox::deck
