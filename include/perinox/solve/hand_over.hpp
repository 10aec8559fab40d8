#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/solve/bond_breaking.hpp"
#include "perinox/solve/boundary.hpp"
#include "perinox/solve/explicit_motion.hpp"
#include "perinox/solve/record.hpp"

namespace perinox::solve {

/// Time that the slowest material's dilatational wave takes through the body's bounding box, corner to corner.
/// Collective. Throws InputError at a material without a density.
double passage_time(const deck::Deck& deck, const mechanics::Scene& scene);

/// Carries a scene whose equilibrium is lost through time, damped, until it is at rest: kinetic energy below
/// hand_over.kinetic_share of the largest stored energy of the phase, and no bond broken for hand_over.quiet_time.
class HandOver {
 public:
  HandOver(const deck::Deck& deck, mechanics::Scene& scene, Boundary& boundary, BondBreaking* breaking);

  struct Result {
    bool at_rest = false;
    std::string reason;  ///< a sentence, where not
    double time = 0;     ///< that the phase took
    long long time_steps = 0;
    long long broken = 0;     ///< bonds over all ranks
    double most_kinetic = 0;  ///< energy
    MotionEnergies energies;  ///< at its end
  };
  /// From `state`, which is replaced by where the motion ends, with the loads going to load parameter `t` over one
  /// passage of a wave and then held, or on at hand_over.rate. force, external: [owned * dimension], at the end. Pieces
  /// that have come loose are taken out once the bonds are quiet; their kinetic energy counts as damped. Collective.
  Result run(mechanics::Committed& state, double t, Observer& observer, std::vector<double>& force,
             std::vector<double>& external);

 private:
  long long break_bonds(ExplicitMotion& motion);
  bool let_loose_go(ExplicitMotion& motion, Observer& observer);

  const deck::Deck& deck_;
  mechanics::Scene& scene_;
  Boundary& boundary_;
  BondBreaking* breaking_;
  double passage_;
};

}  // namespace perinox::solve
