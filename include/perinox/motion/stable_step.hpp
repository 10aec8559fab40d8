#pragma once
#include <optional>
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::motion {

/// Mass of every owned particle, density times volume (2-D: unit thickness). [owned]. Throws InputError at a material
/// without a density.
std::vector<double> particle_masses(const deck::Deck& deck, const mechanics::Scene& scene);

/// explicit.safety, or what stands for it: 0.8, and 0.5 where a material flows, as the plastic work of a time step is
/// that of its end.
double time_step_safety(const deck::Deck& deck, const mechanics::Scene& scene);

/// Upper bound of the largest eigenvalue of M^-1 K of the undeformed elastic body, 1/time^2. A family's energy is at
/// most lambda_i/2 sum omega e^2 V_j with lambda_i = max(alpha_i, d^2 kappa/m_i), or, where the strain is fitted,
/// the largest of alpha_i and of C^(1/2) M^-1 C^(1/2), C the isotropic stiffness; an extension squared at most twice
/// those of its ends; so
///     omega_max^2 <= max_i 2 |B_i| / m_i,   B_i = V_i sum_j omega (lambda_i + lambda_j) n n V_j.
/// Bonds that break only lower it. None where a material has no point formulas of sums. Collective.
std::optional<double> eigenvalue_bound(const mechanics::Scene& scene, const std::vector<double>& masses);

/// The largest eigenvalue itself by Lanczos' method with the matrix-free tangent of the committed state (elastic: what
/// has yielded unloads), 1/time^2: the largest Ritz value and its residual, which is at most a hundredth of it after
/// some 20 products, on top. prescribed: [at least owned * dimension], held. 0 where nothing is free. Collective.
double largest_eigenvalue(const mechanics::Scene& scene, const mechanics::Committed& committed,
                          const std::vector<double>& masses, const std::vector<char>& prescribed,
                          std::shared_ptr<mechanics::Evaluation> evaluation = nullptr);

}  // namespace perinox::motion
