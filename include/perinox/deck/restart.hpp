#pragma once
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"

namespace perinox::deck {

/// What a deck says about checkpoints and about stopping in time.
struct Checkpoints {
  /// Committed steps between checkpoints; 0: no checkpoints; absent: by the clock.
  std::optional<int> every = {};
  double seconds = 5;                     ///< least time between two checkpoints, wall clock
  std::optional<double> time_limit = {};  ///< time limit of the run, wall-clock seconds
};
Checkpoints checkpoints(const Deck& deck);

/// Names what a deck asks for and no checkpoint holds yet, such as "arc-length control". It is "" if a run of the deck
/// can go on from a checkpoint.
std::string not_in_checkpoints(const Deck& deck);

/// A key whose value differs between two checked decks.
struct ChangedKey {
  std::string path;           ///< "boundary[1].displacement.z"
  std::string before, after;  ///< "nothing" if the key is not there
  bool allowed = false;       ///< whether a restart may change it: see may_change()
};

/// All differences between two decks, in the order of the keys. Numbers are compared as numbers. Names of input files
/// are not compared, because the contents of the files are compared elsewhere.
std::vector<ChangedKey> changed_keys(const Value& before, const Value& after);

/// True for the keys that may change between a checkpoint and the run that goes on from it. They decide how steps are
/// found, how many come and what is written, but not which problem is solved.
bool may_change(const std::string& path);

/// The sentence that refuses the changes that are not allowed; "" if all are allowed. It also refuses a deck that ends
/// before t.
std::string refuse_changes(const std::vector<ChangedKey>& changes, const Deck& after, const std::string& checkpoint,
                           double t);

}  // namespace perinox::deck
