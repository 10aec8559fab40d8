#pragma once
#include <cstdint>
#include <vector>

#include "perinox/fracture/bond_limits.hpp"

namespace perinox::fracture {

/// Sorts out the bonds that cannot have come to their limit, so that only few are looked at closely after a time step.
/// Bounds, with no root and no division a bond and eight bonds of a lattice at a time; never misses a critical one.
///
/// With U the difference of the ends' displacements, c = (2 X + U) . U = |Y|^2 - xi^2 and e = c/(|Y| + xi) <= c/(2 xi)
/// where c > 0. The stretch e/xi is at most c/(2 xi^2). The energy omega e (sum over the ends of radial xi + shear e/2
/// + xi N . H) is at most what it is with c/(2 xi) for e and |H| for N . H.
class BondScreen {
 public:
  /// The scene must outlive it. limits: one a body; bonds under a ductile law pass wherever they are stretched.
  BondScreen(const mechanics::Scene& scene, const std::vector<BondLimit>& limits);

  struct Candidate {
    LocalIndex near, far;
    double length;  ///< xi
    double weight;  ///< omega times the quadrature's share
  };
  /// Bonds that may have come to their limit to one in 1e5. displacement: [local * dimension], points: force states
  /// [local * (2 + mandel_size)], null where no limit is an energy; ghosts included in both. Not collective.
  const std::vector<Candidate>& find(const double* displacement, const double* points);

 private:
  void find_on_lattice();
  void find_in_pairs();

  const mechanics::Scene& scene_;
  double stretch_, energy_;  ///< smallest limits of all bodies; infinite: none
  int dimension_;
  std::int64_t guard_ = 0;      ///< cells that the stencil reaches beyond the grid
  std::int64_t cells_ = 0;      ///< of an array
  std::vector<double> values_;  ///< lattice: arrays over the grid; pairs: [slots * 8]
  std::vector<Candidate> found_;
};

}  // namespace perinox::fracture
