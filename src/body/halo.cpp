#include "perinox/body/halo.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Map.hpp>
#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace perinox::body {

namespace {

/// The rank that owns each ghost, from Tpetra's directory.
std::vector<int> owners_of(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned) {
  const auto comm = Teuchos::rcp(new Teuchos::MpiComm<int>(communicator.mpi()));
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const Tpetra::Map<int, GlobalId> map(invalid, Teuchos::ArrayView<const GlobalId>(ids.data(), owned), 0, comm);
  const auto ghosts = static_cast<int>(ids.size()) - owned;
  std::vector<int> owners(static_cast<std::size_t>(ghosts));
  const Tpetra::LookupStatus status = map.getRemoteIndexList(
      Teuchos::ArrayView<const GlobalId>(ids.data() + owned, ghosts), Teuchos::ArrayView<int>(owners.data(), ghosts));
  if (communicator.any(status == Tpetra::IDNotPresent)) throw std::logic_error("a ghost has no owner on any rank");
  return owners;
}

/// One side of the exchange: the local particles that go with each rank, and room for their values.
struct Side {
  std::vector<int> ranks;
  std::vector<std::size_t> begin{0};  ///< [ranks + 1] into index
  std::vector<LocalIndex> index;      ///< local particles
  std::vector<double> buffer;

  void pack(const double* values, std::size_t components) {
    buffer.resize(index.size() * components);
    for (std::size_t k = 0; k < index.size(); ++k)
      for (std::size_t c = 0; c < components; ++c) buffer[k * components + c] = values[index[k] * components + c];
  }
};

constexpr int tag_update = 71, tag_add = 72;

}  // namespace

struct Halo::Plan {
  Communicator communicator;
  MPI_Comm comm = MPI_COMM_NULL;
  Side shared;  ///< owned particles that are other ranks' ghosts
  Side ghosts;  ///< this rank's ghosts
  std::vector<MPI_Request> updating, adding;

  /// Starts to send `from` and to receive into `to`.
  void begin(Side& from, Side& to, std::size_t components, int tag, std::vector<MPI_Request>& requests) const {
    to.buffer.resize(to.index.size() * components);
    requests.clear();
    const auto count = [&](const Side& side, std::size_t k) {
      return static_cast<int>((side.begin[k + 1] - side.begin[k]) * components);
    };
    for (std::size_t k = 0; k < to.ranks.size(); ++k)
      MPI_Irecv(to.buffer.data() + to.begin[k] * components, count(to, k), MPI_DOUBLE, to.ranks[k], tag, comm,
                &requests.emplace_back());
    for (std::size_t k = 0; k < from.ranks.size(); ++k)
      MPI_Isend(from.buffer.data() + from.begin[k] * components, count(from, k), MPI_DOUBLE, from.ranks[k], tag, comm,
                &requests.emplace_back());
  }
  static void end(std::vector<MPI_Request>& requests) {
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }
};

Halo::Halo(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned)
    : owned_(owned), ghosts_(static_cast<int>(ids.size()) - owned) {
  if (communicator.size() == 1) {
    if (ghosts_ > 0) throw std::logic_error("a ghost has no owner: there is one rank only");
    return;
  }
  const std::vector<int> owners = owners_of(communicator, ids, owned);
  plan_ = std::make_shared<Plan>();
  plan_->communicator = communicator;
  plan_->comm = communicator.mpi();

  // Ghosts are sorted by owner, then every owner is told which of its particles are wanted.
  Side& ghosts = plan_->ghosts;
  ghosts.index.resize(static_cast<std::size_t>(ghosts_));
  std::iota(ghosts.index.begin(), ghosts.index.end(), owned);
  std::stable_sort(ghosts.index.begin(), ghosts.index.end(),
                   [&](LocalIndex a, LocalIndex b) { return owners[a - owned] < owners[b - owned]; });
  const auto size = static_cast<std::size_t>(communicator.size());
  std::vector<int> wanted(size, 0), asked(size, 0);
  for (const int owner : owners) ++wanted[owner];
  MPI_Alltoall(wanted.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, plan_->comm);
  const auto starts = [](const std::vector<int>& counts) {
    std::vector<int> begin{0};
    for (const int count : counts) begin.push_back(begin.back() + count);
    return begin;
  };
  const std::vector<int> wanted_begin = starts(wanted), asked_begin = starts(asked);
  std::vector<GlobalId> wanted_ids, asked_ids(static_cast<std::size_t>(asked_begin.back()) + 1);
  for (const LocalIndex ghost : ghosts.index) wanted_ids.push_back(ids[ghost]);
  wanted_ids.push_back(-1);  // keeps the address valid where nothing is wanted
  MPI_Alltoallv(wanted_ids.data(), wanted.data(), wanted_begin.data(), MPI_LONG_LONG, asked_ids.data(), asked.data(),
                asked_begin.data(), MPI_LONG_LONG, plan_->comm);
  Side& shared = plan_->shared;
  for (int k = 0; k < asked_begin.back(); ++k)
    shared.index.push_back(
        static_cast<LocalIndex>(std::lower_bound(ids.begin(), ids.begin() + owned, asked_ids[k]) - ids.begin()));
  for (std::size_t rank = 0; rank < size; ++rank) {
    if (wanted[rank] > 0) {
      ghosts.ranks.push_back(static_cast<int>(rank));
      ghosts.begin.push_back(static_cast<std::size_t>(wanted_begin[rank + 1]));
    }
    if (asked[rank] > 0) {
      shared.ranks.push_back(static_cast<int>(rank));
      shared.begin.push_back(static_cast<std::size_t>(asked_begin[rank + 1]));
    }
  }
}

// The clock also runs while a rank waits for messages. An exchange counts once, at its end.
void Halo::begin_update(const double* values, int components) const {
  if (!plan_) return;
  const auto width = static_cast<std::size_t>(components);
  plan_->shared.pack(values, width);
  plan_->begin(plan_->shared, plan_->ghosts, width, tag_update, plan_->updating);
}

void Halo::end_update(double* values, int components) const {
  if (!plan_) return;
  const Profile::Scope timed(plan_->communicator.profile(), Section::halo);
  const auto width = static_cast<std::size_t>(components);
  Plan::end(plan_->updating);
  const Side& ghosts = plan_->ghosts;
  for (std::size_t k = 0; k < ghosts.index.size(); ++k)
    for (std::size_t c = 0; c < width; ++c) values[ghosts.index[k] * width + c] = ghosts.buffer[k * width + c];
}

void Halo::begin_add(const double* values, int components) const {
  if (!plan_) return;
  const auto width = static_cast<std::size_t>(components);
  plan_->ghosts.pack(values, width);
  plan_->begin(plan_->ghosts, plan_->shared, width, tag_add, plan_->adding);
}

void Halo::end_add(double* values, int components) const {
  if (!plan_) return;
  const Profile::Scope timed(plan_->communicator.profile(), Section::halo);
  const auto width = static_cast<std::size_t>(components);
  Plan::end(plan_->adding);
  const Side& shared = plan_->shared;
  for (std::size_t k = 0; k < shared.index.size(); ++k)
    for (std::size_t c = 0; c < width; ++c) values[shared.index[k] * width + c] += shared.buffer[k * width + c];
}

void Halo::update_ghosts(double* values, int components) const {
  begin_update(values, components);
  end_update(values, components);
}

void Halo::add_to_owners(double* values, int components) const {
  begin_add(values, components);
  end_add(values, components);
  const auto width = static_cast<std::size_t>(components);
  std::fill_n(values + static_cast<std::size_t>(owned_) * width, static_cast<std::size_t>(ghosts_) * width, 0.0);
}

int Halo::neighbors() const { return plan_ ? static_cast<int>(plan_->ghosts.ranks.size()) : 0; }
long long Halo::sent() const { return plan_ ? static_cast<long long>(plan_->shared.index.size()) : 0; }

}  // namespace perinox::body
