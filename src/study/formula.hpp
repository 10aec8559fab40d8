#pragma once
#include <map>
#include <string>
#include <vector>

#include "perinox/deck/expression.hpp"
#include "perinox/deck/location.hpp"

namespace perinox::study {

using Numbers = std::map<std::string, double>;

/// A formula of the deck's kind in which the names of `numbers` stand for their values. `others` are the names that it
/// may use besides ("x", "y", "z", "t"). Throws InputError for a name that is neither, with the nearest one.
deck::Expression formula(const std::string& text, const Numbers& numbers, const std::vector<std::string>& others,
                         const deck::Location& where);

/// `text` with every {name} replaced by the word of that name. Braces around anything but a name stay, because YAML
/// maps are written with them. Throws InputError for an unknown name.
std::string with_words(const std::string& text, const std::map<std::string, std::string>& words,
                       const deck::Location& where);

}  // namespace perinox::study
