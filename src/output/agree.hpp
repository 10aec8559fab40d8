#pragma once
#include <string>

#include "perinox/core/communicator.hpp"

namespace perinox::output {

/// Throws RunError on EVERY rank if any rank passes a non-empty sentence. The sentence of the lowest such rank is
/// thrown, so that all ranks leave together. Collective.
void agree_on_run_error(const Communicator& communicator, const std::string& sentence);

}  // namespace perinox::output
