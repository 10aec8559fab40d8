#pragma once
#include <memory>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/core/types.hpp"

namespace perinox::body {

/// Exchange between the particles a rank owns and its ghosts (copies of other ranks' particles). Arrays are
/// point-major: value of component c of particle i at [i * components + c], owned first, then ghosts. Copies share one
/// plan and its buffers: one exchange of each direction at a time.
class Halo {
 public:
  Halo() = default;
  /// ids: of the owned particles, then of the ghosts; collective. Throws std::logic_error if a ghost has no owner.
  Halo(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned);

  /// Owners' values to their ghosts. Collective.
  void update_ghosts(double* values, int components) const;
  /// Adds the ghosts' values to their owners and clears the ghosts. Collective. Sums do not depend on the order in
  /// which messages arrive.
  void add_to_owners(double* values, int components) const;

  /// The same in two parts, so that work that needs no ghost can be done in between. Between them the owned values may
  /// be read (update) and the ghosts' may not be written (add). end_update writes ghosts' values only, end_add adds to
  /// owned values only and leaves the ghosts'.
  void begin_update(const double* values, int components) const;
  void end_update(double* values, int components) const;
  void begin_add(const double* values, int components) const;
  void end_add(double* values, int components) const;

  int owned() const { return owned_; }
  int ghosts() const { return ghosts_; }
  /// Ranks this one exchanges with, and the owned particles that are others' ghosts (each once for every such rank).
  int neighbors() const;
  long long sent() const;

 private:
  struct Plan;
  std::shared_ptr<Plan> plan_;
  int owned_ = 0;
  int ghosts_ = 0;
};

}  // namespace perinox::body
