#include "perinox/mechanics/scene.hpp"

#include <algorithm>

namespace perinox::mechanics {

Scene::Scene(body::Body body, bonds::Bonds bonds, std::vector<std::unique_ptr<materials::Material>> materials)
    : body_(std::move(body)), bonds_(std::move(bonds)), materials_(std::move(materials)) {
  std::vector<std::pair<std::int64_t, std::int64_t>> needs;  // of each material: values a point, values a bond
  for (const auto& material : materials_) {
    const materials::HistoryLayout layout = material->history();
    needs.emplace_back(static_cast<std::int64_t>(layout.point.size()), layout.per_bond);
  }
  history_.point.assign(1, 0);
  history_.bond.assign(1, 0);
  for (LocalIndex i = 0; i < body_.owned; ++i) {
    const auto& [per_point, per_bond] = needs[body_.material[i]];
    const int count = bonds_.family_size(i);
    history_.point.push_back(history_.point.back() + per_point);
    history_.bond.push_back(history_.bond.back() + per_bond * count);
    largest_family_ = std::max(largest_family_, count);
  }
}

materials::Family Scene::family(LocalIndex i) const {
  const auto first = static_cast<std::size_t>(bonds_.offset[i]);
  materials::Family family;
  family.dimension = body_.dimension;
  family.count = bonds_.family_size(i);
  family.length = bonds_.length.data() + first;
  family.influence = bonds_.influence.data() + first;
  family.weight = bonds_.weight.data() + first;
  family.weighted_volume = bonds_.weighted_volume[i];
  family.continuum_weighted_volume = bonds_.continuum_weighted_volume;
  return family;
}

bool Scene::symmetric() const {
  return std::all_of(materials_.begin(), materials_.end(), [](const auto& material) { return material->symmetric(); });
}

std::vector<std::string> Scene::point_history_names() const {
  std::vector<std::string> names;
  for (const auto& material : materials_)
    for (const std::string& name : material->history().point)
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

Scene build_scene(const deck::Deck& deck, const Communicator& communicator, body::PartitionReport* report) {
  // Materials first: a wrong constant is said before any particle is made.
  std::vector<std::unique_ptr<materials::Material>> materials;
  for (const deck::Material& material : deck.materials) materials.push_back(materials::make(material, deck.dimension));
  const double horizon = body::horizon_length(deck, communicator);
  const double reach = bonds::reach(deck, horizon, body::largest_spacing(deck, communicator));
  body::Body body = body::build(deck, communicator, reach, report);
  bonds::Bonds bonds = bonds::build(deck, body, horizon);
  return Scene(std::move(body), std::move(bonds), std::move(materials));
}

}  // namespace perinox::mechanics
