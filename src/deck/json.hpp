#pragma once
/// Just enough JSON to write a schema. Objects keep the order of their keys.
#include <string>
#include <utility>
#include <vector>

namespace perinox::deck {

class Json {
 public:
  /// A text that is written as it stands: a number, true, false.
  static Json literal(std::string text);
  static Json text(const std::string& text);
  static Json texts(const std::vector<std::string>& words);
  static Json array(std::vector<Json> items = {});
  static Json object();

  /// Adds a key to an object, behind the others.
  Json& set(const std::string& key, Json value);
  /// Adds a key to an object, before the others.
  Json& set_first(const std::string& key, Json value);
  /// Adds a value to an array.
  Json& add(Json value);
  /// The value as text, with two blanks a level and no line feed at the end.
  std::string dump(std::size_t indent = 0) const;

 private:
  enum class Kind { literal, array, object };
  Kind kind_ = Kind::literal;
  std::string text_;
  std::vector<std::pair<std::string, Json>> entries_;  ///< an array's keys are empty
};

}  // namespace perinox::deck
