#pragma once
/// Words that other programs and textbooks use for the things that a deck has a name for.
#include <string>
#include <vector>

namespace perinox::deck {

/// The word of `known` that the given word means, such as young_modulus for E. It is "" if none does.
std::string own_word_for(const std::string& word, const std::vector<std::string>& known);
/// Advice about a thing for which a deck has no key, such as a thickness. It is "" if nothing is known.
std::string advice_on(const std::string& word);

}  // namespace perinox::deck
