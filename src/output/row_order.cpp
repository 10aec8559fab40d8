#include "row_order.hpp"

#include <stdexcept>

namespace perinox::output {

namespace {
GlobalId first_row_of(int rank, int ranks, GlobalId total) { return total * rank / ranks; }

std::vector<int> offsets_of(const std::vector<int>& count) {
  std::vector<int> offset(count.size(), 0);
  for (std::size_t rank = 1; rank < count.size(); ++rank) offset[rank] = offset[rank - 1] + count[rank - 1];
  return offset;
}

/// The rank that holds `row`. The guess total*r/ranks <= row is off by one at most.
int holder_of(GlobalId row, int ranks, GlobalId total) {
  auto rank = static_cast<int>(row * ranks / total);
  while (rank > 0 && first_row_of(rank, ranks, total) > row) --rank;
  while (first_row_of(rank + 1, ranks, total) <= row) ++rank;
  return rank;
}
}  // namespace

RowOrder::RowOrder(const Communicator& communicator, const std::vector<GlobalId>& id, int owned, GlobalId total)
    : communicator_(communicator), total_(total) {
  const int ranks = communicator.size();
  first_row_ = first_row_of(communicator.rank(), ranks, total);
  rows_ = static_cast<int>(first_row_of(communicator.rank() + 1, ranks, total) - first_row_);

  bool sound = true;
  std::vector<int> holder(static_cast<std::size_t>(owned), 0);
  owners_.count.assign(static_cast<std::size_t>(ranks), 0);
  for (std::size_t i = 0; i < holder.size(); ++i) {
    if (id[i] < 0 || id[i] >= total) {
      sound = false;
      continue;
    }
    holder[i] = holder_of(id[i], ranks, total);
    ++owners_.count[static_cast<std::size_t>(holder[i])];
  }
  if (communicator.any(!sound)) throw std::logic_error("a particle's id is outside 0 .. total-1");

  owners_.offset = offsets_of(owners_.count);
  owners_.place.resize(holder.size());
  std::vector<GlobalId> sent(holder.size());
  std::vector<int> next = owners_.offset;
  for (std::size_t i = 0; i < holder.size(); ++i) {
    const auto slot = static_cast<std::size_t>(next[static_cast<std::size_t>(holder[i])]++);
    owners_.place[slot] = static_cast<int>(i);
    sent[slot] = id[i];
  }

  file_.count.resize(static_cast<std::size_t>(ranks));
  MPI_Alltoall(owners_.count.data(), 1, MPI_INT, file_.count.data(), 1, MPI_INT, communicator.mpi());
  file_.offset = offsets_of(file_.count);
  const int received = file_.offset.back() + file_.count.back();
  std::vector<GlobalId> arrived(static_cast<std::size_t>(received));
  MPI_Alltoallv(sent.data(), owners_.count.data(), owners_.offset.data(), MPI_LONG_LONG, arrived.data(),
                file_.count.data(), file_.offset.data(), MPI_LONG_LONG, communicator.mpi());

  std::vector<char> taken(static_cast<std::size_t>(rows_), 0);
  sound = received == rows_;
  file_.place.resize(arrived.size());
  for (std::size_t slot = 0; slot < arrived.size(); ++slot) {
    const auto row = static_cast<std::size_t>(arrived[slot] - first_row_);
    sound = sound && taken[row] == 0;
    taken[row] = 1;
    file_.place[slot] = static_cast<int>(row);
  }
  if (communicator.any(!sound)) throw std::logic_error("the particles' ids are not 0 .. total-1, each exactly once");
}

template <class T>
std::vector<T> RowOrder::exchange(const Side& from, const Side& to, const T* values, int components,
                                  MPI_Datatype type) const {
  const auto width = static_cast<std::size_t>(components);
  std::vector<T> sent(from.place.size() * width);
  for (std::size_t slot = 0; slot < from.place.size(); ++slot)
    for (std::size_t c = 0; c < width; ++c)
      sent[slot * width + c] = values[static_cast<std::size_t>(from.place[slot]) * width + c];

  // Counts are in particles and not in numbers, so that they fit an int in bodies of hundreds of millions of particles
  // a rank.
  MPI_Datatype particle = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(components, type, &particle);
  MPI_Type_commit(&particle);
  std::vector<T> arrived(to.place.size() * width);
  MPI_Alltoallv(sent.data(), from.count.data(), from.offset.data(), particle, arrived.data(), to.count.data(),
                to.offset.data(), particle, communicator_.mpi());
  MPI_Type_free(&particle);

  std::vector<T> placed(arrived.size());
  for (std::size_t slot = 0; slot < to.place.size(); ++slot)
    for (std::size_t c = 0; c < width; ++c)
      placed[static_cast<std::size_t>(to.place[slot]) * width + c] = arrived[slot * width + c];
  return placed;
}

std::vector<double> RowOrder::to_rows(const double* values, int components) const {
  return exchange(owners_, file_, values, components, MPI_DOUBLE);
}
std::vector<int> RowOrder::to_rows(const int* values) const { return exchange(owners_, file_, values, 1, MPI_INT); }
std::vector<GlobalId> RowOrder::to_rows(const GlobalId* values) const {
  return exchange(owners_, file_, values, 1, MPI_LONG_LONG);
}
std::vector<double> RowOrder::to_owners(const double* rows, int components) const {
  return exchange(file_, owners_, rows, components, MPI_DOUBLE);
}

}  // namespace perinox::output
