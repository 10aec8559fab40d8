#pragma once
/// Just enough JSON to write a schema: objects keep their keys' order.
#include <string>
#include <utility>
#include <vector>

namespace perinox::deck {

class Json {
 public:
  /// Text that is written as it stands: a number, true, false.
  static Json literal(std::string text);
  static Json text(const std::string& text);
  static Json texts(const std::vector<std::string>& words);
  static Json array(std::vector<Json> items = {});
  static Json object();

  /// Of an object: adds a key behind the others.
  Json& set(const std::string& key, Json value);
  /// The same before the others.
  Json& set_first(const std::string& key, Json value);
  /// Of an array.
  Json& add(Json value);
  /// Two blanks a level, no line feed at the end.
  std::string dump(std::size_t indent = 0) const;

 private:
  enum class Kind { literal, array, object };
  Kind kind_ = Kind::literal;
  std::string text_;
  std::vector<std::pair<std::string, Json>> entries_;  ///< an array's keys are empty
};

}  // namespace perinox::deck
