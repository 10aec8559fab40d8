#include "perinox/stepping/step_records.hpp"

#include <algorithm>

namespace perinox::stepping {

StepRecords::StepRecords(const deck::Deck& deck, const medium::Model& model) : deck_(deck), model_(model) {
  const std::vector<std::string>& asked = deck.output.fields;
  if (deck.breaks() || std::find(asked.begin(), asked.end(), "fragment") != asked.end())
    fragments_ = std::make_unique<fracture::Fragments>(model);
}

void StepRecords::fill(const State& state, bool written, StepRecord& row) {
  row.history.clear();
  for (const deck::HistoryEntry& entry : deck_.history) row.history.push_back(entry_value(state, entry));
  count_fragments(written, row);
  row.fields = {{"displacement", model_.dimension(), state.displacement.data()},
                {"force", model_.dimension(), state.force}};
  if (state.velocity) row.fields.push_back({"velocity", model_.dimension(), state.velocity});
  row.fields.insert(row.fields.end(), state.fields.begin(), state.fields.end());
  if (fragments_) row.fields.push_back({"fragment", 1, fragments_->number().data()});
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

double StepRecords::entry_value(const State& state, const deck::HistoryEntry& entry) const {
  const std::vector<LocalIndex>& set = model_.body().sets.at(entry.set);
  const int d = model_.dimension();
  std::vector<double> sums(2, 0.0);  // means are by volume: a finer body has more particles in as much of it
  for (const LocalIndex i : set) {
    const auto unknown = static_cast<std::size_t>(i) * d + entry.component;
    const double volume = model_.body().volume[i];
    sums[1] += volume;
    if (entry.kind == deck::HistoryKind::reaction) {
      if (!state.loose.empty() && state.loose[i]) continue;
      sums[0] -= state.force[unknown] + state.external[unknown];  // what the support does to the body
    } else if (entry.kind == deck::HistoryKind::displacement) {
      sums[0] += volume * state.displacement[unknown];
    } else if (state.has_flowed(i)) {
      sums[0] += volume;
    }
  }
  model_.body().communicator.sum(sums);
  return entry.kind == deck::HistoryKind::reaction ? sums[0] : sums[0] / sums[1];
}

}  // namespace perinox::stepping
