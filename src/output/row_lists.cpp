#include "row_lists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "agree.hpp"
#include "not_finite.hpp"

namespace perinox::output {

namespace {
std::vector<int> offsets_of(const std::vector<int>& count) {
  std::vector<int> offset(count.size(), 0);
  for (std::size_t rank = 1; rank < count.size(); ++rank) offset[rank] = offset[rank - 1] + count[rank - 1];
  return offset;
}
}  // namespace

struct RowLists::Portion {
  std::vector<LocalIndex> particles;    ///< particles of this rank whose rows are in the portion, ascending ids
  int first_row = 0, last_row = 0;      ///< range among the rows that this rank holds
  std::vector<int> to_rows, to_owners;  ///< [ranks] count of numbers in each direction
  std::size_t owned_values = 0, row_values = 0;
};

RowLists::RowLists(const body::Body& body, const RowOrder& order, int rows_a_portion)
    : communicator_(body.communicator), order_(order), rows_a_portion_(rows_a_portion) {
  const auto owned = static_cast<std::size_t>(body.owned);
  const std::vector<long long> first = communicator_.gather(static_cast<long long>(order.first_row()));
  holder_.resize(owned);
  long long largest = communicator_.max(static_cast<long long>(order.rows()));
  portions_ = static_cast<int>((largest + rows_a_portion - 1) / rows_a_portion);
  particles_.resize(static_cast<std::size_t>(portions_));
  for (std::size_t i = 0; i < owned; ++i) {  // ids of owned particles ascend
    // The last rank that begins at or before this row: ranks without rows begin where the next one does.
    const auto holder = std::upper_bound(first.begin(), first.end(), body.id[i]) - first.begin() - 1;
    holder_[i] = static_cast<int>(holder);
    const auto number =
        static_cast<std::size_t>((body.id[i] - first[static_cast<std::size_t>(holder)]) / rows_a_portion);
    particles_[number].push_back(static_cast<LocalIndex>(i));
  }
  owner_ = order.to_rows(std::vector<int>(owned, communicator_.rank()).data());
}

RowLists::Portion RowLists::plan(int number, const std::vector<int>& owner_count,
                                 const std::vector<int>& row_count) const {
  const auto ranks = static_cast<std::size_t>(communicator_.size());
  Portion part;
  part.to_rows.assign(ranks, 0);
  part.to_owners.assign(ranks, 0);
  for (const LocalIndex i : particles_[static_cast<std::size_t>(number)]) {
    const int count = owner_count[static_cast<std::size_t>(i)];
    if (count == 0) continue;
    part.particles.push_back(i);
    part.to_rows[static_cast<std::size_t>(holder_[static_cast<std::size_t>(i)])] += count;
    part.owned_values += static_cast<std::size_t>(count);
  }
  const auto rows = static_cast<int>(row_count.size());
  part.first_row = std::min(rows, number * rows_a_portion_);
  part.last_row = std::min(rows, part.first_row + rows_a_portion_);
  for (int row = part.first_row; row < part.last_row; ++row) {
    const int count = row_count[static_cast<std::size_t>(row)];
    part.to_owners[static_cast<std::size_t>(owner_[static_cast<std::size_t>(row)])] += count;
    part.row_values += static_cast<std::size_t>(count);
  }
  return part;
}

void RowLists::write(ParallelFile& file, const std::string& name, const std::vector<int>& count,
                     const StateWriter::Source& source) const {
  const std::vector<int> row_count = order_.to_rows(count.data());
  file.write_rows(name + "/count", row_count, order_.total(), order_.first_row());
  const GlobalId mine = std::accumulate(row_count.begin(), row_count.end(), GlobalId{0});
  const GlobalId total = communicator_.sum(mine);
  file.make_list(name + "/values", total);
  if (total == 0) return;
  const GlobalId place = communicator_.exclusive_scan(mine);
  Stretch stretch = file.list_stretch(name + "/values", place, static_cast<std::size_t>(mine));
  std::vector<double> values, arrived;
  for (int number = 0; number < portions_; ++number) {
    const Portion part = plan(number, count, row_count);
    values.clear();
    values.reserve(part.owned_values);
    source(part.particles, values);
    values.resize(part.owned_values);
    if (communicator_.size() == 1) {  // in ascending ids as they are
      stretch.append(values.data(), values.size());
      continue;
    }
    arrived.resize(part.row_values);
    const std::vector<int> sent = offsets_of(part.to_rows), received = offsets_of(part.to_owners);
    MPI_Alltoallv(values.data(), part.to_rows.data(), sent.data(), MPI_DOUBLE, arrived.data(), part.to_owners.data(),
                  received.data(), MPI_DOUBLE, communicator_.mpi());
    // Each owner's lists have come in ascending ids.
    std::vector<int> next = received;
    for (int row = part.first_row; row < part.last_row; ++row) {
      int& from = next[static_cast<std::size_t>(owner_[static_cast<std::size_t>(row)])];
      const int length = row_count[static_cast<std::size_t>(row)];
      stretch.append(arrived.data() + from, static_cast<std::size_t>(length));
      from += length;
    }
  }
  file.close_list(stretch);
}

void RowLists::refuse_unfit(const ParallelFile& file, const std::string& name,
                            const std::vector<int>& row_count) const {
  GlobalId all = 0, in_portion = 0;
  bool sound = true;
  for (std::size_t row = 0; row < row_count.size(); ++row) {
    if (row % static_cast<std::size_t>(rows_a_portion_) == 0) in_portion = 0;
    in_portion += row_count[row];
    all += row_count[row];
    // A portion's numbers are counted in int, because MPI does so.
    sound = sound && row_count[row] >= 0 && in_portion <= std::numeric_limits<int>::max();
  }
  const GlobalId there = file.list_size(name + "/values");
  const GlobalId wanted = communicator_.sum(all);
  sound = !communicator_.any(!sound) && wanted == there;
  agree_on_run_error(communicator_, sound ? std::string()
                                          : fmt::format("{} does not hold the lists {}: their lengths do not add up to "
                                                        "the {} numbers that are there",
                                                        file.path(), name, std::max(there, GlobalId{0})));
}

std::vector<int> RowLists::read_counts(const ParallelFile& file, const std::string& name) const {
  const std::vector<int> rows = file.read_integers(name + "/count", order_.total(), order_.first_row(), order_.rows());
  refuse_unfit(file, name, rows);
  const std::vector<double> numbers(rows.begin(), rows.end());
  const std::vector<double> owned = order_.to_owners(numbers.data(), 1);
  std::vector<int> count;
  for (const double number : owned) count.push_back(static_cast<int>(number));
  return count;
}

void RowLists::read(const ParallelFile& file, const std::string& name, const std::vector<int>& count,
                    const StateReader::Sink& sink) const {
  const std::vector<int> row_count = order_.to_rows(count.data());
  const GlobalId mine = std::accumulate(row_count.begin(), row_count.end(), GlobalId{0});
  GlobalId place = communicator_.exclusive_scan(mine);
  if (communicator_.sum(mine) == 0) return;
  for (int number = 0; number < portions_; ++number) {
    const Portion part = plan(number, count, row_count);
    const std::vector<double> rows = file.read_part(name + "/values", place, part.row_values);
    refuse_not_finite(communicator_, rows, file.path(), name);
    place += static_cast<GlobalId>(rows.size());
    if (communicator_.size() == 1) {
      sink(part.particles, rows);
      continue;
    }
    std::vector<double> sent(rows.size()), values(part.owned_values);
    const std::vector<int> from = offsets_of(part.to_owners), to = offsets_of(part.to_rows);
    std::vector<int> next = from;
    auto list = rows.begin();
    for (int row = part.first_row; row < part.last_row; ++row) {
      int& where = next[static_cast<std::size_t>(owner_[static_cast<std::size_t>(row)])];
      const int length = row_count[static_cast<std::size_t>(row)];
      std::copy(list, list + length, sent.begin() + where);
      list += length;
      where += length;
    }
    MPI_Alltoallv(sent.data(), part.to_owners.data(), from.data(), MPI_DOUBLE, values.data(), part.to_rows.data(),
                  to.data(), MPI_DOUBLE, communicator_.mpi());
    sink(part.particles, values);
  }
}

}  // namespace perinox::output
