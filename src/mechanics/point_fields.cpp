#include "perinox/mechanics/point_fields.hpp"

#include <algorithm>

namespace perinox::mechanics {

PointFields::PointFields(const Scene& scene, const std::vector<std::string>& asked)
    : scene_(scene),
      history_names_(scene.point_history_names()),
      history_values_(history_names_.size(), std::vector<double>(static_cast<std::size_t>(scene.owned()), 0.0)) {
  const auto asks = [&](const char* field) { return std::find(asked.begin(), asked.end(), field) != asked.end(); };
  if (scene.from_sums() && (asks("stress") || asks("strain") || asks("von_mises_stress")))
    stress_ = std::make_unique<Stress>(scene);
  if (asks("plastic_work")) plastic_work_.resize(static_cast<std::size_t>(scene.owned()));
  for (const auto& material : scene.materials()) {
    std::vector<std::size_t>& places = history_place_.emplace_back();
    for (const std::string& name : material->history().point)
      places.push_back(static_cast<std::size_t>(std::find(history_names_.begin(), history_names_.end(), name) -
                                                history_names_.begin()));
  }
}

void PointFields::spread_history(const Committed& committed) {
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const std::vector<std::size_t>& places = history_place_[static_cast<std::size_t>(scene_.body().material[i])];
    for (std::size_t k = 0; k < places.size(); ++k)
      history_values_[places[k]][i] = committed.point_history(scene_, i)[k];
  }
}

bool PointFields::has_flowed(LocalIndex i) const {
  for (std::size_t k = 0; k < history_names_.size(); ++k)
    if (history_names_[k] == "plastic_multiplier" && history_values_[k][i] > 0) return true;
  return false;
}

std::vector<Field> PointFields::of(const Committed& committed, const std::vector<double>& dilatation,
                                   const std::vector<double>& stored_energy, bool written) {
  spread_history(committed);
  std::vector<Field> all{{"dilatation", 1, dilatation.data()},
                         {"stored_energy", 1, stored_energy.data()},
                         {"damage", 1, scene_.families().damage.data()},
                         {"weighted_volume", 1, scene_.families().weighted_volume.data()}};
  for (std::size_t k = 0; k < history_names_.size(); ++k)
    all.push_back({history_names_[k], 1, history_values_[k].data()});
  if (!plastic_work_.empty()) {
    for (LocalIndex i = 0; i < scene_.owned(); ++i)
      plastic_work_[i] = scene_.material(i).plastic_work(committed.point_history(scene_, i));
    all.push_back({"plastic_work", 1, plastic_work_.data()});
  }
  if (stress_) {
    if (written) stress_->evaluate(committed);
    all.push_back({"stress", 6, stress_->stress().data()});
    all.push_back({"strain", 6, stress_->strain().data()});
    all.push_back({"von_mises_stress", 1, stress_->von_mises().data()});
  }
  return all;
}

}  // namespace perinox::mechanics
