#pragma once
/// Collects what the suite has compared: every comparison under its kind, over all ranks, and the table of it.
#include <string>
#include <vector>

namespace perinox::invariance {

struct Entry {
  std::string kind;   ///< of transformation
  std::string scene;  ///< its name
  double deviation = 0;
  std::string what;  ///< the quantity that deviates most
};

class Ledger {
 public:
  void add(Entry entry) { entries_.push_back(std::move(entry)); }
  /// Entries of all ranks, on all ranks alike. Collective.
  std::vector<Entry> of_all_ranks() const;
  /// Brings the entries of all ranks together, prints one line for each kind (scenes, largest deviation, where) and
  /// every entry beyond its bound, and fails the test for those. Empties the ledger. Collective.
  void judge(const std::string& title);

 private:
  std::vector<Entry> entries_;
};

/// Largest deviation that a kind of transformation may make. Throws std::logic_error for a kind without one.
double bound_of(const std::string& kind);

/// True if the whole suite is asked for, and not the sample of the normal test run (scripts/invariance.sh).
bool everything();

}  // namespace perinox::invariance
