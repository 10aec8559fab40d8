#include "perinox/linear/coarse_spacing.hpp"

#include <algorithm>

namespace perinox::linear {

namespace {

/// Where finer cells pay: above this kappa/mu, and this ratio of the moduli of two materials.
constexpr double nearly_incompressible = 20, strong_contrast = 100;
/// Where the iterations are so many that a third of them, and of their sums over all ranks, is worth a tenth more work.
constexpr double very_nearly_incompressible = 300;

/// Of the materials that particles are made of. Collective.
std::vector<materials::ElasticModuli> moduli_in_use(const medium::Model& model) {
  const std::vector<materials::ElasticModuli> all = model.local_elasticity()->moduli;
  std::vector<double> used(all.size(), 0.0);
  for (LocalIndex i = 0; i < model.owned(); ++i) used[static_cast<std::size_t>(model.body().material[i])] = 1;
  model.body().communicator.max(used);
  std::vector<materials::ElasticModuli> moduli;
  for (std::size_t m = 0; m < used.size(); ++m)
    if (used[m] > 0) moduli.push_back(all[m]);
  return moduli;
}

double largest_ratio(const std::vector<materials::ElasticModuli>& moduli) {
  double ratio = 0;
  for (const materials::ElasticModuli& of : moduli) ratio = std::max(ratio, of.bulk / of.shear);
  return ratio;
}

}  // namespace

double largest_bulk_over_shear(const medium::Model& model) { return largest_ratio(moduli_in_use(model)); }

int chebyshev_steps(const medium::Model& model) {
  return largest_bulk_over_shear(model) > very_nearly_incompressible ? 3 : 1;
}

bool finer_cells_pay(const medium::Model& model) {
  const std::vector<materials::ElasticModuli> moduli = moduli_in_use(model);
  const auto [low, high] =
      std::minmax_element(moduli.begin(), moduli.end(), [](const auto& a, const auto& b) { return a.shear < b.shear; });
  return !model.local_elasticity()->regular || largest_ratio(moduli) > nearly_incompressible ||
         high->shear > strong_contrast * low->shear;
}

}  // namespace perinox::linear
