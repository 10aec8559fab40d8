#include "perinox/body/halo.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>
#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace perinox::body {

namespace {

using Map = Tpetra::Map<int, GlobalId>;
using Import = Tpetra::Import<int, GlobalId>;
using Vector = Tpetra::MultiVector<double, int, GlobalId>;

/// The map of all components of some particles: unknown id * components + c.
Teuchos::RCP<const Map> unknowns(const GlobalId* ids, int count, int components,
                                 const Teuchos::RCP<const Teuchos::Comm<int>>& comm) {
  std::vector<GlobalId> all;
  all.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(components));
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < components; ++c) all.push_back(ids[i] * components + c);
  }
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(
      new Map(invalid, Teuchos::ArrayView<const GlobalId>(all.data(), static_cast<int>(all.size())), 0, comm));
}

/// The exchange for one number of components, with the vectors it goes through: values are copied in and out, so that
/// callers may keep plain arrays.
struct Plan {
  Teuchos::RCP<const Import> import;  ///< from the owned unknowns to the ghosts'
  Teuchos::RCP<Vector> owned, ghosts;
};

}  // namespace

struct Halo::Plans {
  Communicator communicator;
  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  std::vector<GlobalId> ids;
  int owned = 0;
  std::map<int, Plan> by_components;

  const Plan& plan(int components);
};

const Plan& Halo::Plans::plan(int components) {
  const auto found = by_components.find(components);
  if (found != by_components.end()) return found->second;
  Plan plan;
  const auto source = unknowns(ids.data(), owned, components, comm);
  const auto target = unknowns(ids.data() + owned, static_cast<int>(ids.size()) - owned, components, comm);
  plan.import = Teuchos::rcp(new Import(source, target));
  plan.owned = Teuchos::rcp(new Vector(source, 1));
  plan.ghosts = Teuchos::rcp(new Vector(target, 1));
  return by_components.emplace(components, plan).first->second;
}

Halo::Halo(const Communicator& communicator, const std::vector<GlobalId>& ids, int owned)
    : owned_(owned), ghosts_(static_cast<int>(ids.size()) - owned) {
  if (communicator.size() == 1) {
    if (ghosts_ > 0) throw std::logic_error("a ghost has no owner: there is one rank only");
    return;
  }
  plans_ = std::make_shared<Plans>();
  plans_->comm = Teuchos::rcp(new Teuchos::MpiComm<int>(communicator.mpi()));
  plans_->communicator = communicator;
  plans_->ids = ids;
  plans_->owned = owned;
  // Tpetra would only warn of an id that nobody owns, so the directory is asked first.
  const auto map = unknowns(ids.data(), owned, 1, plans_->comm);
  std::vector<int> owners(static_cast<std::size_t>(ghosts_));
  const Tpetra::LookupStatus status = map->getRemoteIndexList(
      Teuchos::ArrayView<const GlobalId>(ids.data() + owned, ghosts_), Teuchos::ArrayView<int>(owners.data(), ghosts_));
  if (communicator.any(status == Tpetra::IDNotPresent)) throw std::logic_error("a ghost has no owner on any rank");
}

void Halo::update_ghosts(double* values, int components) const {
  if (!plans_) return;
  const Profile::Scope timed(plans_->communicator.profile(), Section::halo);
  const Plan& plan = plans_->plan(components);
  const std::size_t split = static_cast<std::size_t>(owned_) * static_cast<std::size_t>(components);
  const std::size_t count = static_cast<std::size_t>(ghosts_) * static_cast<std::size_t>(components);
  std::copy_n(values, split, plan.owned->getDataNonConst(0).getRawPtr());
  plan.ghosts->doImport(*plan.owned, *plan.import, Tpetra::REPLACE);
  std::copy_n(plan.ghosts->getData(0).getRawPtr(), count, values + split);
}

void Halo::add_to_owners(double* values, int components) const {
  if (!plans_) return;
  const Profile::Scope timed(plans_->communicator.profile(), Section::halo);
  const Plan& plan = plans_->plan(components);
  const std::size_t split = static_cast<std::size_t>(owned_) * static_cast<std::size_t>(components);
  const std::size_t count = static_cast<std::size_t>(ghosts_) * static_cast<std::size_t>(components);
  std::copy_n(values, split, plan.owned->getDataNonConst(0).getRawPtr());
  std::copy_n(values + split, count, plan.ghosts->getDataNonConst(0).getRawPtr());
  plan.owned->doExport(*plan.ghosts, *plan.import, Tpetra::ADD);
  std::copy_n(plan.owned->getData(0).getRawPtr(), split, values);
  std::fill_n(values + split, count, 0.0);
}

}  // namespace perinox::body
