#include "energy_scale.hpp"

#include <limits>

namespace perinox::stepping {

double energy_of_rounding(const mechanics::Scene& scene, const std::vector<double>& displacement,
                          const std::vector<char>& loose) {
  constexpr double known_to = 1e-4;
  const auto d = static_cast<std::size_t>(scene.dimension());
  std::vector<double> modulus;
  for (const auto& material : scene.materials()) {
    const materials::ElasticModuli moduli = material->elastic_moduli(scene.dimension());
    modulus.push_back(moduli.bulk + 4.0 / 3 * moduli.shear);
  }
  double sum = 0;
  for (LocalIndex i = 0; i < scene.owned(); ++i) {
    if (!loose.empty() && loose[i]) continue;
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double u = displacement[static_cast<std::size_t>(i) * d + c];
      square += u * u;
    }
    sum += scene.body().volume[i] * modulus[static_cast<std::size_t>(scene.body().material[i])] * square;
  }
  const double horizon = scene.families().horizon;
  return 64 * std::numeric_limits<double>::epsilon() / known_to * scene.body().communicator.sum(sum) /
         (horizon * horizon);
}

}  // namespace perinox::stepping
