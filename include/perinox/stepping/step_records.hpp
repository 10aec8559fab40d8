#pragma once
#include <memory>
#include <string>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/fracture/fragments.hpp"
#include "perinox/mechanics/state.hpp"
#include "perinox/mechanics/stress.hpp"

namespace perinox::stepping {

/// What a run shows of its committed states in step records: the values of deck.history and the point fields.
class StepRecords {
 public:
  StepRecords(const deck::Deck& deck, const mechanics::Scene& scene);

  /// Point values that go with a committed state, of the owned particles; whoever commits keeps them.
  struct State {
    const mechanics::Committed& committed;
    const double* force;               ///< [owned * dimension] internal force
    const double* external;            ///< [owned * dimension] force from outside without that of the supports
    const double* dilatation;          ///< [owned]
    const double* stored_energy;       ///< [owned] energy a volume
    const std::vector<char>& loose;    ///< [owned] 1: taken out, no support acts on it any more; or empty
    const double* velocity = nullptr;  ///< [owned * dimension]; null: not in motion
  };
  /// Fills row.history and row.fields, which point into the state and into this. written: the fields that cost
  /// something are made too. In row.fracture, where there is one, the fragments are counted. Collective.
  void fill(const State& state, bool written, StepRecord& row);

 private:
  void count_fragments(bool written, StepRecord& row);
  void spread_history(const mechanics::Committed& committed);
  double entry_value(const State& state, const deck::HistoryEntry& entry) const;
  std::vector<Field> fields(const State& state, bool written);

  const deck::Deck& deck_;
  const mechanics::Scene& scene_;
  std::vector<std::string> history_names_;
  std::vector<std::vector<std::size_t>> history_place_;  ///< [material][point variable] index into history_names_
  std::vector<std::vector<double>> history_values_;      ///< point history spread over all owned particles
  std::unique_ptr<mechanics::Stress> stress_;            ///< where the deck asks for a field that needs it
  std::vector<double> plastic_work_;                     ///< [owned] if the deck asks for it
  std::unique_ptr<fracture::Fragments> fragments_;       ///< where bonds can break or the deck asks for the field
  long long broken_ = -1;                                ///< bonds when they were counted last; -1: never
};

}  // namespace perinox::stepping
