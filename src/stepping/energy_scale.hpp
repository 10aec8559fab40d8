#pragma once
#include <vector>

#include "perinox/medium/model.hpp"

namespace perinox::stepping {

/// The energy below which no balance of energies means anything, all ranks: 1e4 times what rounding can make of
/// nothing, sum of 64 eps V (kappa + 4/3 mu) |u|^2/horizon^2, where the body has moved by u. A bond's extension is
/// known to eps |u|, so its force works by as much on the way; a body that has only been moved or turned stores nothing
/// else. displacement: [at least owned * dimension]; loose: [owned], left out, or empty. 0 where no moduli are known.
/// Collective.
double energy_of_rounding(const medium::Model& model, const std::vector<double>& displacement,
                          const std::vector<char>& loose);

}  // namespace perinox::stepping
