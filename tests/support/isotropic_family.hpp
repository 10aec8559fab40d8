#pragma once
/// A family of a square or cubic lattice with the direction of every bond. Its influence makes its fourth moment
/// isotropic, so that under uniform strain the plain formulas are those of the local solid.
#include "support/families.hpp"
#include "support/local_plasticity.hpp"

namespace perinox::test {

struct IsotropicFamily {
  IsotropicFamily(int dimension, double radius) {
    const int depth = dimension == 3 ? 4 : 0;
    Vector fourth;
    for (int z = -depth; z <= depth; ++z)
      for (int y = -4; y <= 4; ++y)
        for (int x = -4; x <= 4; ++x) {
          const double r = std::sqrt(x * x + y * y + z * z);
          if (r == 0 || r > radius) continue;
          direction.push_back({x / r, y / r, z / r});
          fourth.push_back(std::pow(x / r, 4) + std::pow(y / r, 4) + std::pow(z / r, 4) - 3.0 / (dimension + 2));
          family.length.push_back(r);
          family.weight.push_back(1);
        }
    double first = 0, second = 0;
    for (std::size_t j = 0; j < direction.size(); ++j) {
      first += family.length[j] * family.length[j] * fourth[j];
      second += std::pow(family.length[j] * fourth[j], 2);
    }
    for (const double value : fourth) family.influence.push_back(1 - first / second * value);
    family.dimension = dimension;
    for (std::size_t j = 0; j < direction.size(); ++j)
      family.weighted_volume += family.influence[j] * family.length[j] * family.length[j];
    family.continuum_weighted_volume = family.weighted_volume;
  }
  static double along(const Tensor& tensor, const std::array<double, 3>& n) {
    return tensor[0] * n[0] * n[0] + tensor[1] * n[1] * n[1] + tensor[2] * n[2] * n[2] +
           2 * (tensor[3] * n[1] * n[2] + tensor[4] * n[0] * n[2] + tensor[5] * n[0] * n[1]);
  }
  Vector extension(const Tensor& strain) const {
    Vector e;
    for (std::size_t j = 0; j < direction.size(); ++j) e.push_back(family.length[j] * along(strain, direction[j]));
    return e;
  }
  /// The collapsed stress: sum t xi n n weight.
  Tensor stress(const Vector& force_state) const {
    Tensor sum{};
    for (std::size_t j = 0; j < direction.size(); ++j) {
      const auto& n = direction[j];
      const double pull = force_state[j] * family.length[j] * family.weight[j];
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += pull * n[c] * n[c];
        sum[c + 3] += pull * n[(c + 1) % 3] * n[(c + 2) % 3];
      }
    }
    return sum;
  }

  RandomFamily family;
  std::vector<std::array<double, 3>> direction;
};

}  // namespace perinox::test
