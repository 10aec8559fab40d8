#pragma once
#include <optional>
#include <string>
#include <vector>

#include "perinox/deck/deck.hpp"

namespace perinox::deck {

/// What a deck says about checkpoints and about stopping in time.
struct Checkpoints {
  std::optional<int> every = {};          ///< committed steps; 0: none; nothing: by the clock
  double seconds = 5;                     ///< between two checkpoints at least, wall clock
  std::optional<double> time_limit = {};  ///< of the run, wall-clock seconds
};
Checkpoints checkpoints(const Deck& deck);

/// What of a deck no checkpoint holds yet, "arc-length control"; "" if a run of it can go on from one.
std::string not_in_checkpoints(const Deck& deck);

/// A key whose value differs between two checked decks.
struct ChangedKey {
  std::string path;           ///< "boundary[1].displacement.z"
  std::string before, after;  ///< "nothing" where the key is not there
  bool allowed = false;       ///< on a restart: see may_change()
};

/// Every difference, in the order of the keys. Numbers are compared as numbers, names of input files not at all: what
/// the files hold is compared elsewhere.
std::vector<ChangedKey> changed_keys(const Value& before, const Value& after);

/// True for the keys that may change between a checkpoint and the run that goes on from it: they decide how steps are
/// found, how many come and what is written, not which problem is solved.
bool may_change(const std::string& path);

/// The sentence that refuses the changes that are not allowed, "" if all are. Also refuses a path that ends before t.
std::string refuse_changes(const std::vector<ChangedKey>& changes, const Deck& after, const std::string& checkpoint,
                           double t);

}  // namespace perinox::deck
