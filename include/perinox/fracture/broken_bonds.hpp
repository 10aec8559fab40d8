#pragma once
/// The bonds that a run has broken, on their way to a checkpoint and back: pairs of ids with the round in which they
/// broke, and the plastic extension that they left, whatever the ranks.
#include <vector>

#include "perinox/core/saved_state.hpp"
#include "perinox/mechanics/scene.hpp"

namespace perinox::fracture {

/// rounds: where in Scene::broken() each call that broke bonds began on this rank; the rounds are the same ones on all
/// ranks. Collective.
void save_broken_bonds(const mechanics::Scene& scene, const std::vector<std::size_t>& rounds, StateWriter& writer);

/// The broken bonds of a checkpoint. They are broken in the rounds of the run that was saved, so that damage adds up as
/// it did then.
class BrokenBonds {
 public:
  /// scene: no bond of it has broken. Throws InputError where it does not have the bonds. Collective.
  BrokenBonds(mechanics::Scene& scene, const StateReader& reader);

  /// Breaks the next rounds until `bonds` of all ranks are broken. With the last of them comes the plastic extension
  /// that they left in their families' sums.
  void break_first(long long bonds);
  /// Over all ranks.
  long long count() const { return count_; }
  /// As for save_broken_bonds, of the rounds so far.
  const std::vector<std::size_t>& rounds() const { return rounds_; }

 private:
  struct Bond {
    std::size_t round;
    mechanics::BondEnds ends;
  };
  mechanics::Scene& scene_;
  std::vector<bonds::BrokenExtension> extension_;  ///< [owned], or empty
  std::vector<Bond> bonds_;                        ///< with an end of this rank's, by rounds
  std::vector<long long> broken_;                  ///< [rounds] over all ranks
  std::vector<std::size_t> rounds_;
  std::size_t next_ = 0;
  long long count_ = 0, done_ = 0;
};

}  // namespace perinox::fracture
