#pragma once
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"

namespace perinox::materials {

/// Isotropic constants, 3-D: bulk modulus k and shear modulus mu (stress).
struct ElasticConstants {
  double bulk = 0;
  double shear = 0;

  double poisson() const { return (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)); }
  double young() const { return 9 * bulk * shear / (3 * bulk + shear); }
  /// kappa of formulation 1: 3-D k; plane strain k + mu/3; plane stress 9 k mu/(3k + 4 mu).
  double bulk_of(deck::Dimension dimension) const;
};

/// The keys bulk_modulus, shear_modulus, young_modulus, poisson_ratio, lame_lambda, and `dilatation`.
std::vector<deck::Key> elastic_keys();

/// From any two of the five; a third is accepted if it agrees to 1e-6. Throws InputError at the deck's line: fewer than
/// two, disagreeing ones, or a pair that gives k <= 0 or mu <= 0.
ElasticConstants elastic_constants(const deck::Material& material);

}  // namespace perinox::materials
