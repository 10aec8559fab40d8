#pragma once
/// The few scalar types every room shares.
#include <cstdint>

namespace perinox {

/// Number of a particle in the whole body, 0-based, 64 bits from the first day.
/// (`long long` is the global ordinal that the packaged Tpetra is instantiated for.)
using GlobalId = long long;

/// Number of a particle on this rank: owned particles come first, then ghosts.
using LocalIndex = int;

}  // namespace perinox
