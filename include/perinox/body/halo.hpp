#pragma once
#include <memory>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::body {

/// Exchange between the particles a rank owns and its ghosts (copies of other ranks' particles), on Tpetra's import
/// plan. Arrays are point-major: value of component c of particle i at [i * components + c], owned first, then ghosts.
class Halo {
 public:
  Halo() = default;
  /// ids: of the owned particles, then of the ghosts; collective. Throws std::logic_error if a ghost has no owner.
  Halo(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned);

  /// Owners' values to their ghosts. Collective.
  void update_ghosts(double* values, int components) const;
  /// Adds the ghosts' values to their owners and clears the ghosts. Collective.
  void add_to_owners(double* values, int components) const;

  int owned() const { return owned_; }
  int ghosts() const { return ghosts_; }

 private:
  struct Plans;
  std::shared_ptr<Plans> plans_;
  int owned_ = 0;
  int ghosts_ = 0;
};

}  // namespace perinox::body
