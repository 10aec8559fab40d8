#pragma once
#include <memory>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::body {

/// Exchanges values between the particles that a rank owns and its ghosts (copies of other ranks' particles). Arrays
/// are point-major: the value of component c of particle i is at [i * components + c], owned particles first, then
/// ghosts. Copies of a halo share one plan and its buffers, so there may be one exchange of each direction at a time.
class Halo {
 public:
  Halo() = default;
  /// ids: those of the owned particles, then those of the ghosts. Collective. Throws std::logic_error if a ghost has no
  /// owner.
  Halo(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned);

  /// Copies the owners' values to their ghosts. Collective.
  void update_ghosts(double* values, int components) const;
  /// Adds the ghosts' values to their owners and clears the ghosts. The sums do not depend on the order in which
  /// messages arrive. Collective.
  void add_to_owners(double* values, int components) const;

  /// The two exchanges in two parts each, so that work that needs no ghost can be done in between. Between the parts
  /// the owned values may be read (update) and the ghosts' values must not be written (add). end_update writes ghosts'
  /// values only. end_add adds to owned values only and leaves the ghosts' as they are. Collective.
  void begin_update(const double* values, int components) const;
  void end_update(double* values, int components) const;
  void begin_add(const double* values, int components) const;
  void end_add(double* values, int components) const;

  int owned() const { return owned_; }
  int ghosts() const { return ghosts_; }
  /// Number of ranks with which this one exchanges.
  int neighbors() const;
  /// Number of owned particles that are ghosts on other ranks, each counted once for every such rank.
  long long sent() const;

 private:
  struct Plan;
  std::shared_ptr<Plan> plan_;
  int owned_ = 0;
  int ghosts_ = 0;
};

}  // namespace perinox::body
