#pragma once
/// A change of the frame and of the units in which a scene is described. The answer must change with it and with
/// nothing else. The new position is length * turn * old position + shift.
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace perinox::invariance {

using Vector3 = std::array<double, 3>;

struct Transformation {
  std::string kind = "none";
  std::array<Vector3, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< orthogonal; a mirror has determinant -1
  Vector3 shift{};                                                 ///< in the new unit of length
  double length = 1;                                               ///< number of new units of length in an old one
  double stress = 1;                                               ///< number of new units of stress in an old one

  Vector3 direction(const Vector3& v) const {
    Vector3 out{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) out[i] += turn[i][k] * v[k];
    return out;
  }
  Vector3 place(const Vector3& x) const {
    Vector3 out = direction(x);
    for (std::size_t i = 0; i < 3; ++i) out[i] = length * out[i] + shift[i];
    return out;
  }
  /// Transforms a symmetric tensor xx xy xz yy yz zz, without a change of unit.
  std::array<double, 6> tensor(const double* s) const;

  /// True if axes go to axes, so that boxes stay boxes.
  bool along_axes() const;
  /// The new axis of an old one, and the sign that it has there. Only where along_axes().
  std::size_t axis(std::size_t old) const;
  double sign(std::size_t old) const { return turn[axis(old)][old]; }
  /// True if formulas of the position have to be written anew.
  bool moves_places() const;

  /// A formula of the old x, y, z as one of the new ones.
  std::string formula(const std::string& text) const;
  /// The factor on a number of this unit of the schema. Times stay as they are, so densities change. Throws
  /// std::logic_error for a unit that it does not know.
  double factor(const std::string& unit, int dimension) const;
};

/// Rotation by an angle about an axis of any length.
std::array<Vector3, 3> rotation(const Vector3& axis, double angle);

/// A number with all its digits.
std::string digits(double value);

}  // namespace perinox::invariance
