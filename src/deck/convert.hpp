#pragma once
/// Converts a checked Value to the plain Deck and applies the rules that span several keys.
#include "perinox/deck/deck.hpp"

namespace perinox::deck {

/// Converts the whole deck. Throws InputError where a point or shape does not fit the dimension or is empty.
Deck convert(Value checked, const std::string& file);

/// Converts a point. `dimension` decides how many entries it has. `third_allowed`: a third entry other than 0 is
/// accepted in 2-D.
Point convert_point(const Value& value, Dimension dimension, const std::string& name, bool third_allowed = false);
Shape convert_shape(const Value& value, Dimension dimension);
Crack convert_crack(const Value& value, Dimension dimension);
/// Throws InputError unless max is greater than min in every direction of the dimension.
void refuse_empty_box(const Point& min, const Point& max, Dimension dimension, const Location& where,
                      const std::string& name);

/// Refuses combinations of the solver's keys that are right one by one but wrong together. `linear` is the checked map
/// of that name. Throws InputError at the key's place.
void refuse_unfit_solver(const Solver& solver, const Value& linear);

Damage convert_damage(const Value& value);
Fracture convert_fracture(const Value& value);
Explicit convert_explicit(const Value& value);
InitialVelocity convert_initial_velocity(const Value& value, Dimension dimension);
HandOver convert_hand_over(const Value& value);
ArcLength convert_arc_length(const Value& value, Dimension dimension);
/// Refuses a deck that lacks what dynamics needs, or that has without dynamics what only dynamics uses. Throws
/// InputError at the key's place.
void refuse_unfit_dynamics(const Deck& deck);
/// Refuses arc-length control of a deck in which nothing depends on t. Throws InputError at the key's place.
void refuse_unfit_arc_length(const Deck& deck);

/// Checks names and references between the deck's parts. Throws InputError at the place of the name.
void check_references(const Deck& deck);

}  // namespace perinox::deck
