#include "perinox/loads/parts.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/body/extent.hpp"

namespace perinox::loads {

namespace {
Parts pieces_of(const medium::Model& model) {
  Parts parts;
  parts.components = bonds::connected_components(model.body(), model.bond_graph());
  parts.diagonal = body::diagonals(model.body(), parts.components.of, parts.components.count());
  return parts;
}
}  // namespace

Parts find_parts(const deck::Deck& deck, const medium::Model& model, const Boundary& boundary) {
  Parts parts = pieces_of(model);
  std::vector<double> free(parts.count(), 0.0), breakable(parts.count(), deck.breaks() ? 0.0 : 1.0);
  const auto d = static_cast<std::size_t>(model.dimension());
  for (std::size_t u = 0; u < model.owned_unknowns(); ++u)
    if (!boundary.prescribed()[u]) free[parts.of(static_cast<LocalIndex>(u / d))] = 1;
  for (LocalIndex i = 0; i < model.owned(); ++i)
    if (deck.materials[static_cast<std::size_t>(model.body().material[i])].damage) breakable[parts.of(i)] = 1;
  model.body().communicator.max(free);
  model.body().communicator.max(breakable);
  for (std::size_t k = 0; k < parts.count(); ++k) parts.moves.push_back(free[k] > 0 && breakable[k] > 0 ? 1 : 0);
  return parts;
}

long long moving_bonds(const medium::Model& model, const Parts& parts) {
  const bool any = std::count(parts.moves.begin(), parts.moves.end(), 1) > 0;
  const bonds::BondGraph graph = model.bond_graph();
  std::vector<LocalIndex> neighbors;
  long long directed = 0;
  for (LocalIndex i = 0; i < model.owned(); ++i)
    if (!any || parts.moves[parts.of(i)]) {
      graph(i, neighbors);
      directed += static_cast<long long>(neighbors.size());
    }
  return model.body().communicator.sum(directed) / 2;
}

bool moves_beyond_small(const medium::Model& model, const Boundary& boundary, const double* displacement) {
  const Communicator& ranks = model.body().communicator;
  double farthest = 0;
  for (std::size_t u = 0; u < model.owned_unknowns(); ++u)
    if (!boundary.prescribed()[u]) farthest = std::max(farthest, std::abs(displacement[u]));
  // No part that resists a load is smaller than the horizon, so that the parts need not be found for a usual step.
  if (ranks.max(farthest) <= 0.5 * model.horizon()) return false;
  const Parts parts = pieces_of(model);
  const auto d = static_cast<std::size_t>(model.dimension());
  std::vector<double> free(parts.count(), 0.0), prescribed(parts.count(), 0.0);
  for (std::size_t u = 0; u < model.owned_unknowns(); ++u) {
    const std::size_t k = parts.of(static_cast<LocalIndex>(u / d));
    double& most = boundary.prescribed()[u] ? prescribed[k] : free[k];
    most = std::max(most, std::abs(displacement[u]));
  }
  ranks.max(free);
  ranks.max(prescribed);
  for (std::size_t k = 0; k < parts.count(); ++k)
    if (free[k] > std::max(0.5 * parts.diagonal[k], 2 * prescribed[k])) return true;
  return false;
}

double loose_energy(const medium::Model& model, const std::vector<char>& loose,
                    const std::vector<double>& stored_energy) {
  double sum = 0;
  for (std::size_t i = 0; i < loose.size(); ++i)
    if (loose[i]) sum += model.body().volume[i] * stored_energy[i];
  return sum;
}

}  // namespace perinox::loads
