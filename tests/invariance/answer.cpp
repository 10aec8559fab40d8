#include "answer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "perinox/output/checkpoint.hpp"
#include "support/restarts.hpp"

namespace perinox::invariance {

namespace {

/// Values of the owned particles of all ranks, on rank 0 in the order of the ids.
class Gathering {
 public:
  explicit Gathering(const body::Body& body) : ranks_(body.communicator), owned_(body.owned) {
    counts_.resize(static_cast<std::size_t>(ranks_.size()));
    MPI_Gather(&owned_, 1, MPI_INT, counts_.data(), 1, MPI_INT, 0, ranks_.mpi());
    const std::vector<double> mine(body.id.begin(), body.id.begin() + body.owned);
    const std::vector<double> id = of_ranks(mine.data(), 1);
    order_.resize(id.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return id[a] < id[b]; });
  }
  std::vector<double> operator()(const double* values, int components) const {
    const std::vector<double> all = of_ranks(values, components);
    const auto n = static_cast<std::size_t>(components);
    std::vector<double> sorted;
    sorted.reserve(all.size());
    for (const std::size_t k : order_) sorted.insert(sorted.end(), &all[k * n], &all[k * n] + n);
    return sorted;
  }

 private:
  std::vector<double> of_ranks(const double* values, int components) const {
    std::vector<int> counts, places;
    int total = 0;
    for (const int count : counts_) {
      counts.push_back(count * components);
      places.push_back(total);
      total += counts.back();
    }
    std::vector<double> all(ranks_.is_root() ? static_cast<std::size_t>(total) : 0);
    MPI_Gatherv(values, owned_ * components, MPI_DOUBLE, all.data(), counts.data(), places.data(), MPI_DOUBLE, 0,
                ranks_.mpi());
    return all;
  }

  Communicator ranks_;
  int owned_;
  std::vector<int> counts_;
  std::vector<std::size_t> order_;
};

/// Keeps the rows of a run, and the fields of its last step.
class Keeper : public Observer {
 public:
  Keeper(const deck::Deck& deck, const Gathering& gathering, Answer& answer)
      : deck_(deck), gathering_(gathering), answer_(answer) {}
  void step_committed(const StepRecord& record) override {
    Answer::Row row;
    row.t = record.t;
    row.energies = {record.stored_energy, record.dissipated_energy, record.external_work};
    for (std::size_t k = 0; k < record.history.size(); ++k) {
      const deck::HistoryKind kind = deck_.history[k].kind;
      (kind == deck::HistoryKind::reaction       ? row.reactions
       : kind == deck::HistoryKind::displacement ? row.movements
                                                 : row.shares)
          .push_back(record.history[k]);
    }
    if (record.fracture) row.broken_bonds = record.fracture->broken_bonds;
    answer_.rows.push_back(row);
    for (const Field& field : record.fields)
      answer_.fields[field.name] = {field.components, gathering_(field.values, field.components)};
  }

 private:
  const deck::Deck& deck_;
  const Gathering& gathering_;
  Answer& answer_;
};

void describe(const mechanics::Scene& scene, const Gathering& gathering, Answer& answer) {
  const body::Body& body = scene.body();
  std::vector<double> place, family;
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const deck::Point x = body.position3(i);
    place.insert(place.end(), x.begin(), x.end());
    family.push_back(scene.families().size[static_cast<std::size_t>(i)]);
  }
  answer.dimension = body.dimension;
  answer.place = gathering(place.data(), 3);
  answer.volume = gathering(body.volume.data(), 1);
  for (const double count : gathering(family.data(), 1)) answer.family.push_back(std::llround(count));
  const double mean = std::accumulate(answer.volume.begin(), answer.volume.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(answer.volume.size(), 1));
  answer.spacing = std::pow(mean, 1.0 / body.dimension);
}

template <class Stepper>
void run(Stepper& stepper, Observer& keeper, Answer& answer) {
  try {
    stepper.run(keeper);
  } catch (const RunError& error) {
    answer.stopped = error.what();
  }
}

}  // namespace

Answer answer_of(const std::string& yaml, const std::string& folder, MPI_Comm comm) {
  Answer answer;
  try {
    const deck::Deck deck = deck::read_text(yaml, folder + "/deck.yaml", materials::full_schema());
    mechanics::Scene scene = mechanics::build_scene(deck, Communicator(comm));
    const Gathering gathering(scene.body());
    describe(scene, gathering, answer);
    Keeper keeper(deck, gathering, answer);
    if (deck.dynamics == deck::Dynamics::explicit_) {
      stepping::TimeStepper stepper(deck, scene);
      run(stepper, keeper, answer);
    } else {
      stepping::LoadStepper stepper(deck, scene);
      run(stepper, keeper, answer);
    }
  } catch (const InputError& error) {
    answer = {};
    answer.refused = error.what();
  }
  return answer;
}

}  // namespace perinox::invariance
