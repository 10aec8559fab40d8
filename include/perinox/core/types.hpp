#pragma once
/// The few scalar types that all rooms share.
#include <cstdint>

namespace perinox {

/// Number of a particle in the whole body, counted from 0. It has 64 bits because a body may have more particles than
/// an int can count; `long long` is the global ordinal for which the packaged Tpetra is instantiated.
using GlobalId = long long;

/// Number of a particle on this rank. Owned particles come first, then ghosts.
using LocalIndex = int;

}  // namespace perinox
