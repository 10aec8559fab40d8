#include "perinox/grid/shared_nodes.hpp"

#include <algorithm>
#include <iterator>

namespace perinox::grid {

SharedNodes::SharedNodes(const Communicator& ranks, const std::vector<GlobalId>& ids)
    : comm_(ranks.mpi()), rank_(ranks.rank()), counted_(ids.size(), 1) {
  long long counted = static_cast<long long>(ids.size());
  if (ranks.size() > 1) {
    const std::vector<long long> counts = ranks.gather(counted), all = ranks.gather(ids);
    auto begin = all.begin();
    for (int rank = 0; rank < ranks.size(); ++rank) {
      const auto end = begin + static_cast<std::ptrdiff_t>(counts[static_cast<std::size_t>(rank)]);
      Neighbor neighbor{rank, {}};
      auto theirs = begin;
      for (std::size_t n = 0; n < ids.size() && rank != rank_; ++n) {
        theirs = std::lower_bound(theirs, end, ids[n]);
        if (theirs == end) break;
        if (*theirs == ids[n]) neighbor.nodes.push_back(static_cast<LocalIndex>(n));
      }
      begin = end;
      if (neighbor.nodes.empty()) continue;
      for (const LocalIndex n : neighbor.nodes)
        if (rank < rank_) counted_[n] = 0;
      shared_.insert(shared_.end(), neighbor.nodes.begin(), neighbor.nodes.end());
      neighbors_.push_back(std::move(neighbor));
    }
    std::sort(shared_.begin(), shared_.end());
    shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    counted = std::count(counted_.begin(), counted_.end(), 1);
  }
  total_ = ranks.sum(counted);
}

template <class Number, class Combine>
void SharedNodes::exchange(Number* values, int width, MPI_Datatype type, const Combine& combine) const {
  if (neighbors_.empty()) return;
  const auto w = static_cast<std::size_t>(width);
  std::vector<std::vector<Number>> sent, received;
  std::vector<MPI_Request> requests;
  sent.reserve(neighbors_.size());
  received.reserve(neighbors_.size());
  for (const Neighbor& neighbor : neighbors_) {
    const int count = static_cast<int>(neighbor.nodes.size() * w);
    received.emplace_back(static_cast<std::size_t>(count));
    requests.emplace_back();
    MPI_Irecv(received.back().data(), count, type, neighbor.rank, 0, comm_, &requests.back());
  }
  for (const Neighbor& neighbor : neighbors_) {
    sent.emplace_back();
    sent.back().reserve(neighbor.nodes.size() * w);
    for (const LocalIndex n : neighbor.nodes)
      sent.back().insert(sent.back().end(), values + n * w, values + (n + 1) * w);
    requests.emplace_back();
    MPI_Isend(sent.back().data(), static_cast<int>(sent.back().size()), type, neighbor.rank, 0, comm_,
              &requests.back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);

  // Shares are combined in the order of the ranks, so that the sum is the same on all of them to the last bit. This
  // rank's own share takes its turn.
  std::vector<Number> own;
  own.reserve(shared_.size() * w);
  for (const LocalIndex n : shared_) own.insert(own.end(), values + n * w, values + (n + 1) * w);
  std::vector<char> begun(counted_.size(), 0);
  const auto take = [&](const std::vector<LocalIndex>& nodes, const std::vector<Number>& from) {
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const auto n = static_cast<std::size_t>(nodes[k]);
      for (std::size_t c = 0; c < w; ++c)
        if (begun[n])
          combine(values[n * w + c], from[k * w + c]);
        else
          values[n * w + c] = from[k * w + c];
      begun[n] = 1;
    }
  };
  bool own_taken = false;
  for (std::size_t k = 0; k < neighbors_.size(); ++k) {
    if (!own_taken && neighbors_[k].rank > rank_) {
      take(shared_, own);
      own_taken = true;
    }
    take(neighbors_[k].nodes, received[k]);
  }
  if (!own_taken) take(shared_, own);
}

template void SharedNodes::exchange(double*, int, MPI_Datatype, const SharedNodes::Sum&) const;
template void SharedNodes::exchange(long long*, int, MPI_Datatype, const SharedNodes::Lowest&) const;

}  // namespace perinox::grid
