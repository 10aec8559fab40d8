/// The coarse system, large: one V-cycle of MueLu's smoothed aggregation. A heavy translation unit.
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>
#include <cstdlib>

#include "perinox/core/tpetra.hpp"
#include "perinox/solve/coarse_solver.hpp"

namespace perinox::solve {

namespace {

using Teuchos::RCP;
using Teuchos::rcp;
using Ids = Teuchos::ArrayView<const GlobalId>;

/// The map of all components of some nodes.
RCP<const tpetra::Map> unknowns_of(const std::vector<GlobalId>& nodes, std::size_t d,
                                   const RCP<const Teuchos::Comm<int>>& comm) {
  std::vector<GlobalId> all;
  all.reserve(nodes.size() * d);
  for (const GlobalId node : nodes)
    for (std::size_t c = 0; c < d; ++c) all.push_back(node * static_cast<GlobalId>(d) + static_cast<GlobalId>(c));
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return rcp(new tpetra::Map(invalid, Ids(all.data(), static_cast<int>(all.size())), 0, comm));
}

/// Rigid motions at the given nodes: the near null space of elasticity.
RCP<tpetra::MultiVector> rigid_motions(const RCP<const tpetra::Map>& map, const std::vector<double>& positions,
                                       std::size_t d) {
  const std::size_t count = d == 3 ? 6 : 3;
  auto motions = rcp(new tpetra::MultiVector(map, count));
  const auto value = motions->getLocalViewHost(Tpetra::Access::OverwriteAll);
  for (std::size_t n = 0; n < positions.size() / d; ++n) {
    const double* x = &positions[n * d];
    for (std::size_t c = 0; c < d; ++c)
      for (std::size_t k = 0; k < count; ++k) value(n * d + c, k) = c == k ? 1 : 0;
    if (d == 2) {
      value(n * d, 2) = -x[1];
      value(n * d + 1, 2) = x[0];
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {  // about axis k
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      value(n * d + a, 3 + k) = -x[b];
      value(n * d + b, 3 + k) = x[a];
    }
  }
  return motions;
}

class Multigrid : public CoarseSolver {
 public:
  Multigrid(const Communicator& ranks, const CoarseGrid& grid, const CoarseMatrix& matrix, int smoothing) {
    const auto d = static_cast<std::size_t>(matrix.dimension);
    const RCP<const Teuchos::Comm<int>> comm = rcp(new Teuchos::MpiComm<int>(ranks.mpi()));
    // Every node is owned by one of the ranks that hold it. Owners number theirs one after the other, which is what
    // MueLu's aggregation likes best.
    const std::vector<GlobalId>& ids = grid.node_ids();
    const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
    const RCP<const tpetra::Map> held =
        rcp(new tpetra::Map(invalid, Ids(ids.data(), static_cast<int>(ids.size())), 0, comm));
    const RCP<const tpetra::Map> owned = ranks.size() > 1 ? Tpetra::createOneToOne(held) : held;
    const auto owned_count = static_cast<GlobalId>(owned->getNodeNumElements());
    const GlobalId before = ranks.exclusive_scan(owned_count);
    Tpetra::Vector<double, LocalIndex, GlobalId> own_number(owned), number(held);
    for (GlobalId k = 0; k < owned_count; ++k)
      own_number.replaceLocalValue(static_cast<LocalIndex>(k), static_cast<double>(before + k));
    const Tpetra::Import<LocalIndex, GlobalId> spread(owned, held);
    number.doImport(own_number, spread, Tpetra::REPLACE);
    std::vector<GlobalId> held_numbers, owned_numbers;
    const auto numbers = number.getData();
    for (std::size_t n = 0; n < ids.size(); ++n) held_numbers.push_back(std::llround(numbers[static_cast<int>(n)]));
    for (GlobalId k = 0; k < owned_count; ++k) owned_numbers.push_back(before + k);

    held_map_ = unknowns_of(held_numbers, d, comm);
    owned_map_ = ranks.size() > 1 ? unknowns_of(owned_numbers, d, comm) : held_map_;
    to_owners_ = rcp(new tpetra::Export(held_map_, owned_map_));
    right_ = rcp(new tpetra::Vector(owned_map_));
    solution_ = rcp(new tpetra::Vector(owned_map_));
    held_right_ = rcp(new tpetra::Vector(held_map_));
    held_solution_ = rcp(new tpetra::Vector(held_map_));

    RCP<tpetra::Matrix> shares = share_of(matrix, d);
    shares->fillComplete(owned_map_, owned_map_);
    matrix_ = ranks.size() == 1
                  ? shares
                  : Tpetra::exportAndFillCompleteCrsMatrix<tpetra::Matrix>(shares, *to_owners_, owned_map_, owned_map_);

    // Positions of the owned nodes.
    Tpetra::MultiVector<double, LocalIndex, GlobalId> held_positions(held, d), own_positions(owned, d);
    for (std::size_t n = 0; n < ids.size(); ++n)
      for (std::size_t c = 0; c < d; ++c)
        held_positions.replaceLocalValue(static_cast<LocalIndex>(n), c, grid.node_positions()[n * d + c]);
    const tpetra::Export gather(held, owned);
    own_positions.doExport(held_positions, gather, Tpetra::REPLACE);
    auto coordinates = rcp(new tpetra::MultiVector(unknowns_of(owned_numbers, 1, comm), d));
    std::vector<double> positions(static_cast<std::size_t>(owned_count) * d);
    for (std::size_t c = 0; c < d; ++c) {
      const auto values = own_positions.getData(c);
      for (std::size_t n = 0; n < static_cast<std::size_t>(owned_count); ++n) {
        positions[n * d + c] = values[static_cast<int>(n)];
        coordinates->replaceLocalValue(static_cast<LocalIndex>(n), c, positions[n * d + c]);
      }
    }

    Teuchos::ParameterList list;
    list.set("verbosity", "none");
    list.set("number of equations", matrix.dimension);
    list.set("problem: symmetric", true);
    list.set("multigrid algorithm", "sa");
    // Measured on 14 739 unknowns: Chebyshev of degree 2 costs half of one symmetric Gauss-Seidel sweep (its products
    // run over contiguous memory) and gives the same iterations, 16; of degree 1 it gives 19 to 20.
    // Two levels at least: see below.
    const auto unknowns = static_cast<GlobalId>(owned_map_->getGlobalNumElements());
    list.set("coarse: max size", static_cast<int>(std::min<GlobalId>(500, unknowns / 4)));
    list.set("smoother: type", "CHEBYSHEV");
    auto& smoother = list.sublist("smoother: params");
    smoother.set("chebyshev: degree", smoothing);
    smoother.set("chebyshev: ratio eigenvalue", 20.0);
    list.sublist("user data").set("Nullspace", rigid_motions(owned_map_, positions, d));
    if (ranks.size() > 1) {
      // Levels that would leave a rank only a few rows move to fewer ranks, the last one to a single rank: small levels
      // are all latency, and the packaged KLU2 solves wrongly on several ranks.
      list.set("repartition: enable", true);
      list.set("repartition: start level", 1);
      list.set("repartition: min rows per proc", 2000);
      list.set("repartition: partitioner", "zoltan2");
      list.sublist("repartition: params").set("algorithm", "multijagged");
      list.sublist("user data").set("Coordinates", Teuchos::rcp_implicit_cast<tpetra::MultiVector>(coordinates));
    }
    // The smoothers' estimates of eigenvalues start from random vectors, and Tpetra's go on from the C library's random
    // numbers: a cycle made again later, or after a restart, is the same.
    std::srand(1);
    const RCP<tpetra::Operator> as_operator = matrix_;
    cycle_ = MueLu::CreateTpetraPreconditioner(as_operator, list);
  }

  void solve(const double* right, double* solution) override {
    const std::size_t held = held_map_->getNodeNumElements();
    {
      const auto to = held_right_->getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t u = 0; u < held; ++u) to(u, 0) = right[u];
    }
    right_->putScalar(0);
    right_->doExport(*held_right_, *to_owners_, Tpetra::ADD);
    solution_->putScalar(0);
    cycle_->apply(*right_, *solution_);
    held_solution_->doImport(*solution_, *to_owners_, Tpetra::REPLACE);
    const auto from = held_solution_->getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t u = 0; u < held; ++u) solution[u] = from(u, 0);
  }
  long long unknowns() const override { return static_cast<long long>(owned_map_->getGlobalNumElements()); }
  std::size_t bytes() const override { return matrix_->getNodeNumEntries() * (sizeof(double) + sizeof(LocalIndex)); }

 private:
  RCP<tpetra::Matrix> share_of(const CoarseMatrix& matrix, std::size_t d) const {
    std::vector<std::size_t> lengths;
    for (std::size_t n = 0; n + 1 < matrix.row_begin.size(); ++n)
      lengths.insert(lengths.end(), d, (matrix.row_begin[n + 1] - matrix.row_begin[n]) * d);
    auto share = rcp(new tpetra::Matrix(held_map_, held_map_, Teuchos::ArrayView<const std::size_t>(lengths)));
    std::vector<LocalIndex> columns;
    std::vector<double> values;
    for (std::size_t n = 0; n + 1 < matrix.row_begin.size(); ++n)
      for (std::size_t p = 0; p < d; ++p) {
        columns.clear();
        values.clear();
        for (std::size_t k = matrix.row_begin[n]; k < matrix.row_begin[n + 1]; ++k)
          for (std::size_t q = 0; q < d; ++q) {
            columns.push_back(static_cast<LocalIndex>(static_cast<std::size_t>(matrix.column[k]) * d + q));
            values.push_back(matrix.value[(k * d + p) * d + q]);
          }
        share->insertLocalValues(static_cast<LocalIndex>(n * d + p), Teuchos::ArrayView<const LocalIndex>(columns),
                                 Teuchos::ArrayView<const double>(values));
      }
    return share;
  }

  RCP<const tpetra::Map> held_map_, owned_map_;
  RCP<const tpetra::Export> to_owners_;
  RCP<tpetra::Vector> right_, solution_, held_right_, held_solution_;
  RCP<tpetra::Matrix> matrix_;
  RCP<tpetra::Operator> cycle_;
};

}  // namespace

std::unique_ptr<CoarseSolver> multigrid_coarse_solver(const Communicator& ranks, const CoarseGrid& grid,
                                                      const CoarseMatrix& matrix, int smoothing) {
  return std::make_unique<Multigrid>(ranks, grid, matrix, smoothing);
}

}  // namespace perinox::solve
