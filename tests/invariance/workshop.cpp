#include "workshop.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "support/restarts.hpp"

namespace perinox::invariance {

WorkFolder::WorkFolder() {
  static int count = 0;
  path_ =
      (std::filesystem::temp_directory_path() / fmt::format("perinox_invariance_{}_{}", ::getpid(), count++)).string();
  std::filesystem::create_directories(path_);
}
WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

int rank_of_world() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}
int ranks_of_world() {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

namespace {

/// Does the work. Any exception counts as a deviation of 1, whose name is the exception's sentence.
template <class Work>
void noted(Ledger& ledger, const std::string& kind, const std::string& scene, Work&& work) {
  Entry entry{kind, scene, 1, ""};
  try {
    entry.deviation = work(entry.what);
  } catch (const std::exception& error) {
    entry.what = error.what();
  }
  ledger.add(entry);
}

}  // namespace

void compare(Ledger& ledger, const std::string& scene, const Answer& base, const Variant& variant,
             const std::string& folder) {
  noted(ledger, variant.kind, scene, [&](std::string& what) {
    const Answer answer = answer_of(variant.yaml, folder, MPI_COMM_SELF);
    return deviation(base, answer, variant.change, variant.rows, variant.more, &what);
  });
}

void compare_restarts(Ledger& ledger, const std::string& scene, const std::string& yaml, const std::string& folder) {
  noted(ledger, "restarted after every step", scene, [&](std::string& what) {
    using namespace perinox::test;
    const deck::Deck deck = deck::read_text(yaml, folder + "/deck.yaml", materials::full_schema());
    const CheckpointFolder checkpoints{Communicator(MPI_COMM_SELF)};
    const RunResult whole = run_with_checkpoints(deck, MPI_COMM_SELF, "", &checkpoints);
    double largest = 0;
    for (std::size_t k = 0; k + 1 < whole.records.steps.size(); ++k) {
      const int step = whole.records.steps[k].step;
      const RunResult part = run_with_checkpoints(deck, MPI_COMM_SELF, checkpoints.of_step(step), nullptr);
      const double apart =
          std::max({relative_difference(part.displacement, whole.displacement),
                    relative_difference(part.force, whole.force), history_difference(whole, part, step + 1)});
      if (!(apart <= largest)) largest = apart, what = fmt::format("after step {}", step);
    }
    return largest;
  });
}

void compare_ranks(Ledger& ledger, const std::string& scene, const Answer& base, const std::string& yaml,
                   const std::string& folder, int first) {
  const int size = ranks_of_world();
  const int place = (rank_of_world() - first + size) % size;
  for (int ranks = 2; ranks <= std::min(4, size); ++ranks) {
    MPI_Comm some = MPI_COMM_NULL;
    MPI_Comm_split(MPI_COMM_WORLD, place < ranks ? 0 : MPI_UNDEFINED, place, &some);
    if (some == MPI_COMM_NULL) continue;
    Answer answer;
    try {
      answer = answer_of(yaml, folder, some);
    } catch (const std::exception& error) {
      answer.refused = error.what();
    }
    if (place == 0)
      noted(ledger, fmt::format("ranks: {}", ranks), scene,
            [&](std::string& what) { return deviation(base, answer, {}, Rows::all, false, &what); });
    MPI_Comm_free(&some);
  }
}

}  // namespace perinox::invariance
