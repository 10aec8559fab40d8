#pragma once
#include <vector>

#include "perinox/bonds/components.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::loads {

/// The parts of a scene that no bond joins at the moment. What is measured against "the size of the body" or "all its
/// bonds" is measured part by part, so that a body far away changes no answer.
struct Parts {
  bonds::Components components;
  std::vector<double> diagonal;  ///< [count] of the part's bounding box before loading: length
  /// [count] 1 where some displacement of the part is free and, where the deck breaks bonds, some of its bonds can
  /// break.
  std::vector<char> moves;

  std::size_t count() const { return diagonal.size(); }
  std::size_t of(LocalIndex i) const { return static_cast<std::size_t>(components.of[i]); }
};

/// Visits each bond once. Collective.
Parts find_parts(const deck::Deck& deck, const medium::Model& model, const Boundary& boundary);

/// Bonds over all ranks of the parts that move; of all parts where none does. Collective.
long long moving_bonds(const medium::Model& model, const Parts& parts);

/// True where some part's free displacement is more than half the part's diagonal, and not because twice that is
/// prescribed for it: `deformation: small` cannot mean such a displacement. displacement: [owned * dimension], length.
/// Collective.
bool moves_beyond_small(const medium::Model& model, const Boundary& boundary, const double* displacement);

/// Energy stored in particles that have been taken out of the unknowns as loose, this rank's share. The body no longer
/// has it. loose: [owned] or empty; stored_energy: [owned] a volume.
double loose_energy(const medium::Model& model, const std::vector<char>& loose,
                    const std::vector<double>& stored_energy);

}  // namespace perinox::loads
