#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Map.hpp>

#include "perinox/medium/tangent.hpp"

namespace perinox::medium {

namespace {
Teuchos::RCP<const tpetra::Map> map_of(const body::Body& body, int count) {
  Teuchos::Array<GlobalId> unknowns;
  unknowns.reserve(static_cast<std::ptrdiff_t>(count) * body.dimension);
  for (int i = 0; i < count; ++i)
    for (int c = 0; c < body.dimension; ++c) unknowns.push_back(body.id[i] * body.dimension + c);
  const auto comm = Teuchos::rcp(new Teuchos::MpiComm<int>(body.communicator.mpi()));
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new tpetra::Map(invalid, unknowns(), 0, comm));
}
}  // namespace

Teuchos::RCP<const tpetra::Map> unknowns_map(const body::Body& body) { return map_of(body, body.owned); }
Teuchos::RCP<const tpetra::Map> local_unknowns_map(const body::Body& body) { return map_of(body, body.local()); }

}  // namespace perinox::medium
