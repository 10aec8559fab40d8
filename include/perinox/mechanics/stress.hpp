#pragma once
#include <array>
#include <memory>
#include <vector>

#include "perinox/mechanics/state.hpp"

namespace perinox::mechanics {

class FamilyLoops;

/// Stress and strain of the owned particles, for output. With w = omega weight, M and S(e) = sum w xi N e of
/// bonds/moment.hpp:
///     strain eps = M^-1 S(e), the tensor that tells the family's extensions best,
///     stress sigma = sum t xi N weight, t the force state: the derivative of the energy by a uniform strain eps, the
///     collapsed stress of Lehoucq and Silling where deformations are small.
/// Both are along the axes of the undeformed body and turn with it. Exact under uniform strain where the strain is
/// fitted or M isotropic. Where a family cannot tell all strains apart, those it cannot are taken as zero.
class Stress {
 public:
  /// Only for scenes that are made of sums (Scene::from_sums). Collective.
  explicit Stress(const Scene& scene);
  ~Stress();

  /// Of the committed state. Collective.
  void evaluate(const Committed& committed);

  /// [owned * 6] xx xy xz yy yz zz; stress.
  const std::vector<double>& stress() const { return stress_; }
  /// [owned * 6] xx xy xz yy yz zz.
  const std::vector<double>& strain() const { return strain_; }
  /// [owned] root of 3/2 dev sigma : dev sigma; stress.
  const std::vector<double>& von_mises() const { return von_mises_; }

 private:
  using Square = std::array<double, 36>;  ///< row-major, mandel_size squared
  struct Family {
    Square moment{}, inverse{};
  };
  void find_moments();
  void put(LocalIndex i, const bonds::Mandel& value, double zz, std::vector<double>& to) const;

  const Scene& scene_;
  std::unique_ptr<FamilyLoops> loops_;
  std::vector<Family> families_;         ///< those that differ
  std::vector<std::int32_t> family_of_;  ///< [owned] index into families_
  std::vector<double> stress_, strain_, von_mises_;
  std::uint64_t bonds_version_ = 0;
};

}  // namespace perinox::mechanics
