#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "perinox/core/record.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/fracture/fragments.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::stepping {

/// What a run shows of its committed states in step records: the values of deck.history and the point fields.
class StepRecords {
 public:
  StepRecords(const deck::Deck& deck, const medium::Model& model);

  /// Point values that go with a committed state, of the owned particles; whoever commits keeps them.
  struct State {
    const std::vector<double>& displacement;  ///< [at least owned * dimension]
    const double* force;                      ///< [owned * dimension] internal force
    const double* external;                   ///< [owned * dimension] force from outside without that of the supports
    const std::vector<char>& loose;           ///< [owned] 1: taken out, no support acts on it any more; or empty
    const double* velocity;                   ///< [owned * dimension]; null: not in motion
    std::vector<Field> fields;                ///< the medium's own
    std::function<bool(LocalIndex)> has_flowed;  ///< owned particle
  };
  /// Fills row.history and row.fields, which point into the state and into this. written: the fragments are found even
  /// if no bond has broken since they were found last. In row.fracture, where there is one, they are counted.
  /// Collective.
  void fill(const State& state, bool written, StepRecord& row);

 private:
  void count_fragments(bool written, StepRecord& row);
  double entry_value(const State& state, const deck::HistoryEntry& entry) const;

  const deck::Deck& deck_;
  const medium::Model& model_;
  std::unique_ptr<fracture::Fragments> fragments_;  ///< where bonds can break or the deck asks for the field
  long long broken_ = -1;                           ///< bonds when they were counted last; -1: never
};

}  // namespace perinox::stepping
