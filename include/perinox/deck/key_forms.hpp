#pragma once
/// Short forms of the declarations of keys that occur often.
#include <string>
#include <vector>

#include "perinox/deck/schema.hpp"

namespace perinox::deck {

Key number_key(std::string name, std::string unit, std::string sentence);
Key positive_key(std::string name, std::string unit, std::string sentence);
Key integer_key(std::string name, double minimum, double maximum, std::string fallback, std::string sentence);
Key word_key(std::string name, std::vector<std::string> words, std::string fallback, std::string sentence);
Key text_key(std::string name, std::string sentence);
Key boolean_key(std::string name, bool fallback, std::string sentence);
Key point_key(std::string name, std::string unit, std::string sentence);
Key expression_key(std::string name, std::string unit, std::string sentence);
Key path_key(std::string name, std::string sentence);
Key map_key(std::string name, std::string sentence, std::vector<Key> keys);
/// A map with exactly one of `keys`.
Key choice_key(std::string name, std::string sentence, std::vector<Key> keys);
Key list_key(std::string name, std::string sentence, Key element);
Key required(Key key);

}  // namespace perinox::deck
