#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "perinox/deck/location.hpp"

namespace perinox::deck {

/// A checked piece of a deck: a scalar, a list, or a map, each with its place in the file. Immutable after reading;
/// cheap to copy. Defaults carry the location of the map they were filled into.
class Value {
 public:
  enum class Kind { none, scalar, list, map };

  Kind kind() const;
  const Location& location() const;
  /// False where the schema's default was filled in.
  bool given() const;

  // maps
  /// True if the key has a value, written or by default; false for an optional key that was left out.
  bool has(const std::string& key) const;
  /// A value of kind `none` for an optional key that was left out. Throws std::logic_error for a key the schema does
  /// not have: a fault of the program, not of the user.
  const Value& at(const std::string& key) const;
  /// The keys that have a value, in the schema's order (for user-chosen names: in the file's order).
  const std::vector<std::pair<std::string, Value>>& entries() const;
  /// The optional keys that were left out and have no default.
  std::vector<std::string> absent_keys() const;
  // lists
  const std::vector<Value>& items() const;
  // scalars (already checked against the schema's type)
  double number() const;
  long long integer() const;
  bool boolean() const;
  const std::string& text() const;
  /// True for the name of an input file; its text() is the path that opens it.
  bool is_file() const;
  /// An input file's name as the deck has it, which starts at the deck's folder unless it is absolute.
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
