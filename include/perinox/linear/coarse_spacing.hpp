#pragma once
#include "perinox/medium/model.hpp"

// All of these need Model::local_elasticity().
namespace perinox::linear {

/// Largest kappa/mu of the materials that particles are made of. Collective.
double largest_bulk_over_shear(const medium::Model& model);

/// True where the two-level preconditioner's cells are smaller than a horizon (TwoLevel::Settings::finer_cell): they
/// save iterations everywhere, but make a coarse solve as dear as a product over a lattice. Points of a cloud take two
/// to three times as long, and near incompressibility and strong contrasts need them. Collective.
bool finer_cells_pay(const medium::Model& model);

/// Steps of Chebyshev's iteration with the two-level preconditioner that make one of the Krylov method's iterations:
/// 3 where some material is so nearly incompressible (kappa/mu > 300) that the preconditioner alone takes a hundred,
/// else 1. Collective.
int chebyshev_steps(const medium::Model& model);

}  // namespace perinox::linear
