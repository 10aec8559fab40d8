#include "perinox/stepping/step_records.hpp"

#include <algorithm>

namespace perinox::stepping {

StepRecords::StepRecords(const deck::Deck& deck, const mechanics::Scene& scene)
    : deck_(deck),
      scene_(scene),
      history_names_(scene.point_history_names()),
      history_values_(history_names_.size(), std::vector<double>(static_cast<std::size_t>(scene.owned()), 0.0)) {
  const auto asks = [&](const char* field) {
    return std::find(deck.output.fields.begin(), deck.output.fields.end(), field) != deck.output.fields.end();
  };
  if (scene.from_sums() && (asks("stress") || asks("strain") || asks("von_mises_stress")))
    stress_ = std::make_unique<mechanics::Stress>(scene);
  if (deck.breaks() || asks("fragment")) fragments_ = std::make_unique<fracture::Fragments>(scene);
  if (asks("plastic_work")) plastic_work_.resize(static_cast<std::size_t>(scene.owned()));
  for (const auto& material : scene.materials()) {
    std::vector<std::size_t>& places = history_place_.emplace_back();
    for (const std::string& name : material->history().point)
      places.push_back(static_cast<std::size_t>(std::find(history_names_.begin(), history_names_.end(), name) -
                                                history_names_.begin()));
  }
}

void StepRecords::fill(const State& state, bool written, StepRecord& row) {
  spread_history(state.committed);
  row.history.clear();
  for (const deck::HistoryEntry& entry : deck_.history) row.history.push_back(entry_value(state, entry));
  count_fragments(written, row);
  row.fields = fields(state, written);
}

void StepRecords::count_fragments(bool written, StepRecord& row) {
  if (!fragments_) return;
  const long long broken = row.fracture ? row.fracture->broken_bonds : 0;
  if (broken != broken_ || written) fragments_->find();
  broken_ = broken;
  if (!row.fracture) return;
  row.fracture->fragments = fragments_->several();
  row.fracture->single_particles = fragments_->single();
}

void StepRecords::spread_history(const mechanics::Committed& committed) {
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const std::vector<std::size_t>& places = history_place_[static_cast<std::size_t>(scene_.body().material[i])];
    for (std::size_t k = 0; k < places.size(); ++k)
      history_values_[places[k]][i] = committed.point_history(scene_, i)[k];
  }
}

double StepRecords::entry_value(const State& state, const deck::HistoryEntry& entry) const {
  const std::vector<LocalIndex>& set = scene_.body().sets.at(entry.set);
  const int d = scene_.dimension();
  std::vector<double> sums(2, 0.0);  // means are by volume: a finer body has more particles in as much of it
  for (const LocalIndex i : set) {
    const auto unknown = static_cast<std::size_t>(i) * d + entry.component;
    const double volume = scene_.body().volume[i];
    sums[1] += volume;
    if (entry.kind == deck::HistoryKind::reaction) {
      if (!state.loose.empty() && state.loose[i]) continue;
      sums[0] -= state.force[unknown] + state.external[unknown];  // what the support does to the body
    } else if (entry.kind == deck::HistoryKind::displacement) {
      sums[0] += volume * state.committed.displacement()[unknown];
    } else {
      for (std::size_t k = 0; k < history_names_.size(); ++k)
        if (history_names_[k] == "plastic_multiplier" && history_values_[k][i] > 0) sums[0] += volume;
    }
  }
  scene_.body().communicator.sum(sums);
  return entry.kind == deck::HistoryKind::reaction ? sums[0] : sums[0] / sums[1];
}

std::vector<Field> StepRecords::fields(const State& state, bool written) {
  std::vector<Field> all{{"displacement", scene_.dimension(), state.committed.displacement().data()},
                         {"force", scene_.dimension(), state.force},
                         {"dilatation", 1, state.dilatation},
                         {"stored_energy", 1, state.stored_energy},
                         {"damage", 1, scene_.families().damage.data()},
                         {"weighted_volume", 1, scene_.families().weighted_volume.data()}};
  if (state.velocity) all.push_back({"velocity", scene_.dimension(), state.velocity});
  for (std::size_t k = 0; k < history_names_.size(); ++k)
    all.push_back({history_names_[k], 1, history_values_[k].data()});
  if (!plastic_work_.empty()) {
    for (LocalIndex i = 0; i < scene_.owned(); ++i)
      plastic_work_[i] = scene_.material(i).plastic_work(state.committed.point_history(scene_, i));
    all.push_back({"plastic_work", 1, plastic_work_.data()});
  }
  if (fragments_) all.push_back({"fragment", 1, fragments_->number().data()});
  if (stress_) {
    if (written) stress_->evaluate(state.committed);
    all.push_back({"stress", 6, stress_->stress().data()});
    all.push_back({"strain", 6, stress_->strain().data()});
    all.push_back({"von_mises_stress", 1, stress_->von_mises().data()});
  }
  return all;
}

}  // namespace perinox::stepping
