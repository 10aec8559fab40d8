#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/fracture/bond_breaking.hpp"
#include "perinox/loads/boundary.hpp"
#include "perinox/loads/parts.hpp"
#include "perinox/motion/explicit_motion.hpp"

namespace perinox::stepping {

/// Time that the dilatational wave of a part's slowest material takes through the part's bounding box, corner to
/// corner, or through one horizon if that is longer: the longest of all parts that move. Collective. Throws InputError
/// at a material without a density.
double passage_time(const deck::Deck& deck, const mechanics::Scene& scene, const loads::Parts& parts);

/// Carries a scene whose equilibrium is lost through time, damped, until it is at rest: kinetic energy below
/// hand_over.kinetic_share of the largest stored energy of the phase, and no bond broken for hand_over.quiet_time.
class HandOver {
 public:
  /// passage: time in which a load step is made up for, passage_time() of the scene before any bond broke.
  HandOver(const deck::Deck& deck, mechanics::Scene& scene, loads::Boundary& boundary, fracture::BondBreaking* breaking,
           double passage, std::shared_ptr<mechanics::Evaluation> evaluation);

  struct Result {
    bool at_rest = false;
    std::string reason;  ///< a sentence, where not
    double time = 0;     ///< that the phase took
    long long time_steps = 0;
    long long broken = 0;             ///< bonds over all ranks
    double most_kinetic = 0;          ///< energy
    motion::MotionEnergies energies;  ///< at its end
  };
  /// Takes `state` over; the loads go to load parameter `t` over one passage of a wave and are then held, or go on at
  /// hand_over.rate. patience: 1, or more after a rest where Newton found no equilibrium: beyond a limit point a body
  /// may move so slowly at first that it seems to rest. It is watched so much longer, the kinetic energy asked for is
  /// so much lower, and the damping too unless the deck gives it. Collective.
  void begin(mechanics::Committed&& state, double t, double patience);
  double patience() const { return patience_; }
  /// Called every few time steps, on every rank, when all can be saved; what it throws ends the phase there.
  using Passing = std::function<void(double t)>;
  /// From begin() or restore() until the body is at rest. state, and force, external [owned * dimension]: where the
  /// motion ends. Pieces that have come loose are taken out once the bonds are quiet; their kinetic and stored
  /// energy counts as damped. Collective.
  Result run(mechanics::Committed& state, Observer& observer, std::vector<double>& force, std::vector<double>& external,
             const Passing& passing);
  /// What run() goes on from in a callback, and the way back, with the boundary and the bonds of then. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

 private:
  void make_motion(mechanics::Committed&& state, double rate);
  /// One time step, and the bonds that break after it.
  void advance(double dt);
  bool let_loose_go(Observer& observer);

  const deck::Deck& deck_;
  mechanics::Scene& scene_;
  loads::Boundary& boundary_;
  fracture::BondBreaking* breaking_;
  double passage_;
  std::shared_ptr<mechanics::Evaluation> evaluation_;
  std::unique_ptr<motion::ExplicitMotion> motion_;
  double to_ = 0;  ///< load parameter
  double last_break_ = 0, most_stored_ = 0;
  double patience_ = 1;
  long long estimated_ = 0;  ///< time steps done at the last estimate
  Result result_;
};

}  // namespace perinox::stepping
