#pragma once
/// What a refusal adds about the remedy, such as "; write {tension: 203.1}"; "" where nothing is known. It knows by
/// name what users bring along from other programs and from habit.
#include <string>
#include <vector>

#include "document.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::deck {

/// The remedy for a value of the wrong form: a number where a map is wanted, a map where a list is, a list where a map
/// is.
std::string right_form(const Node& found, const Key& wanted, const Schema& schema);

/// The remedy for a number that does not read as one: with a unit, a decimal comma, digits in groups, or a formula.
std::string right_number(const Node& found);

/// The remedy for a key of the map `map` that is none of `known`: the colon or blank that it lacks, the key's own word
/// for it, the part of the deck to which it belongs, or the keys that there are.
std::string right_key(const Node& map, const Entry& entry, const std::vector<std::string>& known, const Schema& schema);

}  // namespace perinox::deck
