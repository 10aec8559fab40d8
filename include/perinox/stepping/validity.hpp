#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/core/saved_state.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/motion/interpenetration.hpp"
#include "perinox/stepping/plastic_stretch.hpp"

namespace perinox::stepping {

/// Looks at committed states for what the model does not hold for, and says it: faces that pass into each other in
/// equilibria (in every step, where they do), and bonds that flow and are stretched too far (when they first are).
/// Scenes in which neither can be cost nothing.
class Validity {
 public:
  /// Collective.
  Validity(const deck::Deck& deck, const mechanics::Scene& scene);

  /// One committed state. loose: [owned] or empty, particles that are out of the model. Collective.
  void look(const mechanics::Committed& state, int step, const std::vector<char>& loose, Observer& observer);

  /// Depth of the last state, where the deck may have faces that meet: 0 where none overlap.
  std::optional<double> overlap() const { return overlap_; }
  /// What to say at the end of a run, a sentence each, of all states since t = 0.
  std::vector<std::string> at_end() const;

  /// Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

 private:
  bool faces_are_open() const;

  const mechanics::Scene& scene_;
  bool always_ = false;  ///< faces that may meet are there from the start
  std::unique_ptr<motion::Interpenetration> faces_;
  bool flows_ = false;
  std::optional<double> overlap_;
  motion::Overlap deepest_;
  BondStretch longest_;
};

}  // namespace perinox::stepping
