#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/mechanics/stress.hpp"

namespace perinox::mechanics {

/// The fields that a peridynamic state has besides its displacement, force and velocity.
class PointFields {
 public:
  /// asked: names of fields; those that cost something are made only if they are among them.
  PointFields(const Scene& scene, const std::vector<std::string>& asked);

  /// Fields of a committed state, which point into the arguments and into this. dilatation, stored_energy: [owned] of
  /// that state. written: the fields that cost something are brought up to date. Collective.
  std::vector<Field> of(const Committed& committed, const std::vector<double>& dilatation,
                        const std::vector<double>& stored_energy, bool written);
  /// True if owned particle i has flowed in the state that of() was called for last.
  bool has_flowed(LocalIndex i) const;

 private:
  void spread_history(const Committed& committed);

  const Scene& scene_;
  std::vector<std::string> history_names_;
  std::vector<std::vector<std::size_t>> history_place_;  ///< [material][point variable] index into history_names_
  std::vector<std::vector<double>> history_values_;      ///< point history spread over all owned particles
  std::unique_ptr<Stress> stress_;                       ///< where a field that needs it is asked for
  std::vector<double> plastic_work_;                     ///< [owned] if it is asked for
};

}  // namespace perinox::mechanics
