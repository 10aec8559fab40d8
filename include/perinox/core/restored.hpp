#pragma once
/// Numbers of a saved state that the rest of the program can stand between bounds only. Collective; outside of them
/// the state is refused with InputError on every rank.
#include <limits>
#include <string>

#include "perinox/core/saved_state.hpp"

namespace perinox {

/// The whole number of this name, within [least, most].
long long restored_integer(const StateReader& reader, const std::string& name, long long least, long long most);

/// The same where it is kept in an int and counts something.
int restored_count(const StateReader& reader, const std::string& name, int most = std::numeric_limits<int>::max());

/// The number of this name, finite and not below `least`.
double restored_number(const StateReader& reader, const std::string& name, double least);

}  // namespace perinox
