#include "perinox/linear/coarse_spacing.hpp"

#include <algorithm>

namespace perinox::linear {

namespace {

/// Where finer cells pay: above this kappa/mu, and this ratio of the moduli of two materials.
constexpr double nearly_incompressible = 20, strong_contrast = 100;
/// Where the iterations are so many that a third of them, and of their sums over all ranks, is worth a tenth more work.
constexpr double very_nearly_incompressible = 300;

/// Of the materials that particles are made of. Collective.
std::vector<materials::ElasticModuli> moduli_in_use(const mechanics::Scene& scene) {
  std::vector<double> used(scene.materials().size(), 0.0);
  for (LocalIndex i = 0; i < scene.owned(); ++i) used[static_cast<std::size_t>(scene.body().material[i])] = 1;
  scene.body().communicator.max(used);
  std::vector<materials::ElasticModuli> moduli;
  for (std::size_t m = 0; m < used.size(); ++m)
    if (used[m] > 0) moduli.push_back(scene.materials()[m]->elastic_moduli(scene.dimension()));
  return moduli;
}

double largest_ratio(const std::vector<materials::ElasticModuli>& moduli) {
  double ratio = 0;
  for (const materials::ElasticModuli& of : moduli) ratio = std::max(ratio, of.bulk / of.shear);
  return ratio;
}

}  // namespace

double largest_bulk_over_shear(const mechanics::Scene& scene) { return largest_ratio(moduli_in_use(scene)); }

int chebyshev_steps(const mechanics::Scene& scene) {
  return largest_bulk_over_shear(scene) > very_nearly_incompressible ? 3 : 1;
}

bool finer_cells_pay(const mechanics::Scene& scene) {
  const std::vector<materials::ElasticModuli> moduli = moduli_in_use(scene);
  const auto [low, high] =
      std::minmax_element(moduli.begin(), moduli.end(), [](const auto& a, const auto& b) { return a.shear < b.shear; });
  return !scene.lattice() || largest_ratio(moduli) > nearly_incompressible ||
         high->shear > strong_contrast * low->shear;
}

}  // namespace perinox::linear
