#pragma once
/// Words of other programs and of textbooks for what a deck calls by one name.
#include <string>
#include <vector>

namespace perinox::deck {

/// The one of `known` that the word means: young_modulus for E. "" if none does.
std::string own_word_for(const std::string& word, const std::vector<std::string>& known);
/// What to do about a thing that a deck has no key for, such as a thickness; "" if nothing is known.
std::string advice_on(const std::string& word);

}  // namespace perinox::deck
