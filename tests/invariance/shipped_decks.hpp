#pragma once
/// The decks of inputs/, as text that can be changed.
#include <string>
#include <vector>

#include "rewriting.hpp"

namespace perinox::invariance {

std::vector<std::string> shipped_names();
/// A deck of inputs/ with tolerances so tight that only rounding is left.
DeckText shipped(const std::string& name);
/// The deck up to its step `steps`, or the whole deck if it does not have so many.
std::string shortened(const std::string& yaml, int steps);
int steps_of(const std::string& yaml);
/// True if its steps go along an arc.
bool follows_a_path(const std::string& yaml);
/// True if particles are named by their numbers, which other rows would change.
bool names_particles(const std::string& yaml);

}  // namespace perinox::invariance
