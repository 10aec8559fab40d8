#pragma once
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::materials {

/// The isotropic elastic constants of the 3-D solid: bulk modulus k and shear modulus mu, both stresses.
struct ElasticConstants {
  double bulk = 0;
  double shear = 0;

  double poisson() const { return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)); }
  double young() const { return 9 * bulk * shear / (3 * bulk + shear); }
  /// kappa of the dimension at hand (docs/theory.md, section 2): k in 3-D, k + mu/3 in plane strain and 9 k mu/(3k + 4
  /// mu) in plane stress.
  double bulk_of(deck::Dimension dimension) const;
};

/// The deck's keys bulk_modulus, shear_modulus, young_modulus, poisson_ratio, lame_lambda and `dilatation`.
std::vector<deck::Key> elastic_keys();

/// The constants that follow from any two of the five. Further ones are accepted if they agree to 1e-6. Throws
/// InputError at the deck's line if there are fewer than two, if they disagree, or if a pair gives k <= 0 or mu <= 0.
ElasticConstants elastic_constants(const deck::Material& material);

}  // namespace perinox::materials
