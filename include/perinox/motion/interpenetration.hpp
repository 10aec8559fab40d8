#pragma once
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"
#include "perinox/motion/exposed_pairs.hpp"

namespace perinox::motion {

/// How deep faces have passed into each other at worst, and where.
struct Overlap {
  double depth = 0;     ///< length; 0: nowhere beyond the tolerance
  double spacings = 0;  ///< depth over the mean spacing of the pair
  double t = 0;
  int step = 0;
  deck::Point place{};  ///< middle of the pair in the undeformed body
};
/// "faces that no bond joins overlap by ... (... spacings) at (x, y, z)".
std::string describe(const Overlap& overlap);

/// Sees faces pass into each other that nothing keeps apart: of cracks, of broken bonds and of bodies that are not
/// bonded, in equilibria without contact.
///
/// Each exposed particle has a normal N out of its body, against the lean of its intact bonds, and a deformation
/// gradient F, fitted to them. A pair a, b that shares no intact bond, whose faces looked at each other at the start
/// (N_a . xi > 0 > N_b . xi) and look at each other now (n_a . n_b < 0.5, n = F^-T N/|F^-T N|), and that lies across
/// the faces (sideways by at most 0.75 spacings) overlaps by
///     depth = rest - n . (y_b - y_a),   n = (n_a - n_b)/|n_a - n_b|,
/// where the rest distance is that of two layers that touch, h stretched as the material beside them is, or where that
/// is less and a and b began within a horizon, what their distance would be if the body were whole,
/// n . (F_a + F_b)/2 xi. So strain of any size, turning, sliding and opening are not taken for an overlap; what sliding
/// can do because the two normals are not quite opposite is taken off the depth. Particles of bodies one particle thick
/// have no normal: the distance of the two is looked at. With small strain normals do not turn.
class Interpenetration {
 public:
  explicit Interpenetration(const mechanics::Scene& scene);

  /// The deepest overlap at displacement [local * dimension], ghosts up to date; loose: [owned] or empty, particles
  /// that are out of the model. Collective.
  Overlap measure(const std::vector<double>& displacement, const std::vector<char>& loose);

 private:
  std::vector<double> sides(const std::vector<double>& displacement, const std::vector<char>& loose) const;

  const mechanics::Scene& scene_;
  ExposedPairs near_;
  std::uint64_t bonds_version_;
};

}  // namespace perinox::motion
