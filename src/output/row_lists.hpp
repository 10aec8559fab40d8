#pragma once
#include <functional>
#include <string>
#include <vector>

#include "parallel_file.hpp"
#include "perinox/body/body.hpp"
#include "perinox/core/saved_state.hpp"
#include "row_order.hpp"

namespace perinox::output {

/// Lists of numbers in a file, one list for each particle and each of its own length. `<name>/count` [n] holds the
/// lengths, and `<name>/values` the lists one after the other, both in ascending id of the particles whatever the
/// ranks. They pass in portions, so that large ones are never held twice. The plan is made once.
class RowLists {
 public:
  /// Number of particles of each rank's rows that pass at a time. A portion of plastic extension holds 122 numbers a
  /// particle.
  static constexpr int portion = 4096;

  /// order: that of the same body; kept by reference. Collective.
  RowLists(const body::Body& body, const RowOrder& order, int rows_a_portion = portion);

  /// Writes the lists. Collective. Throws RunError if the disk refuses.
  void write(ParallelFile& file, const std::string& name, const std::vector<int>& count,
             const StateWriter::Source& source) const;
  /// Reads the lengths of the lists. [owned] Collective. Throws RunError if they cannot be those of the lists in the
  /// file.
  std::vector<int> read_counts(const ParallelFile& file, const std::string& name) const;
  /// Reads the lists. count: as read_counts() has returned it for this name. Collective.
  void read(const ParallelFile& file, const std::string& name, const std::vector<int>& count,
            const StateReader::Sink& sink) const;

 private:
  /// How one portion of lists goes between the ranks that own the particles and those that hold the rows.
  struct Portion;
  /// Refuses lengths that do not fit the lists. row_count: [rows] as the file has them. Collective.
  void refuse_unfit(const ParallelFile& file, const std::string& name, const std::vector<int>& row_count) const;
  Portion plan(int number, const std::vector<int>& owner_count, const std::vector<int>& row_count) const;

  Communicator communicator_;
  const RowOrder& order_;
  int rows_a_portion_;
  int portions_ = 0;
  std::vector<int> holder_;                         ///< [owned] the rank that holds the particle's row
  std::vector<int> owner_;                          ///< [rows] the rank that owns the row's particle
  std::vector<std::vector<LocalIndex>> particles_;  ///< [portions] ascending ids
};

}  // namespace perinox::output
