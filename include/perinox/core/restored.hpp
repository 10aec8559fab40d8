#pragma once
/// Reads numbers of a saved state and checks that they lie between bounds, because the rest of the program relies on
/// these. All functions are collective. A number out of bounds makes every rank refuse the state with InputError.
#include <limits>
#include <string>

#include "perinox/core/saved_state.hpp"

namespace perinox {

/// The whole number of this name. It must lie within [least, most].
long long restored_integer(const StateReader& reader, const std::string& name, long long least, long long most);

/// A count of this name, kept in an int. It must lie within [0, most].
int restored_count(const StateReader& reader, const std::string& name, int most = std::numeric_limits<int>::max());

/// The number of this name. It must be finite and at least `least`.
double restored_number(const StateReader& reader, const std::string& name, double least);

}  // namespace perinox
