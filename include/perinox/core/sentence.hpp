#pragma once
#include <string>

#include "perinox/core/communicator.hpp"

namespace perinox {

/// The sentence of the lowest rank that has one, on every rank; "" if none has. Collective.
std::string first_sentence(const Communicator& ranks, const std::string& mine);

}  // namespace perinox
