#include "energy_scale.hpp"

#include <limits>
#include <optional>

namespace perinox::stepping {

double energy_of_rounding(const medium::Model& model, const std::vector<double>& displacement,
                          const std::vector<char>& loose) {
  constexpr double known_to = 1e-4;
  const auto d = static_cast<std::size_t>(model.dimension());
  const std::optional<medium::LocalElasticity> elasticity = model.local_elasticity();
  if (!elasticity) return 0;
  std::vector<double> modulus;
  for (const materials::ElasticModuli& moduli : elasticity->moduli)
    modulus.push_back(moduli.bulk + 4.0 / 3 * moduli.shear);
  double sum = 0;
  for (LocalIndex i = 0; i < model.owned(); ++i) {
    if (!loose.empty() && loose[i]) continue;
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double u = displacement[static_cast<std::size_t>(i) * d + c];
      square += u * u;
    }
    sum += model.body().volume[i] * modulus[static_cast<std::size_t>(model.body().material[i])] * square;
  }
  const double horizon = model.horizon();
  return 64 * std::numeric_limits<double>::epsilon() / known_to * model.body().communicator.sum(sum) /
         (horizon * horizon);
}

}  // namespace perinox::stepping
