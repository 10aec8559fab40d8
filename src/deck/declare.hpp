#pragma once
/// The declarations of the deck's keys, as data. One function a part of the deck; Schema puts them together.
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// The whole deck. The models' names become the words of `materials.<name>.model`.
Key declare_deck(const std::vector<ModelDeclaration>& models);

/// The definition `shape`, which contains itself.
Key declare_shape();
Key declare_body();
Key declare_cracks();
Key declare_sets();
Key declare_boundary();
Key declare_solver();

// Short forms of the declarations that occur often.
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
