#include "direct_solve.hpp"

#include <Eigen/SparseLU>
#include <Tpetra_CrsMatrix.hpp>
#include <limits>
#include <stdexcept>

namespace perinox::linear {

namespace {

/// How much each rank sends to rank 0, and where it goes there.
struct Shares {
  std::vector<int> count, start;
  int total = 0;
  int mine = 0;

  Shares(std::size_t size, const Communicator& communicator) : mine(static_cast<int>(size)) {
    if (communicator.sum(static_cast<double>(size)) > std::numeric_limits<int>::max())
      throw std::runtime_error("the direct solver takes no matrix of more than 2e9 entries; take method: automatic");
    for (const long long one : communicator.gather(static_cast<long long>(size))) {
      count.push_back(static_cast<int>(one));
      start.push_back(total);
      total += count.back();
    }
  }
};

template <class T>
std::vector<T> to_root(const T* values, MPI_Datatype type, const Shares& shares, const Communicator& communicator) {
  std::vector<T> all(communicator.is_root() ? static_cast<std::size_t>(shares.total) : 0);
  MPI_Gatherv(values, shares.mine, type, all.data(), shares.count.data(), shares.start.data(), type, 0,
              communicator.mpi());
  return all;
}

}  // namespace

struct DirectSolve::Root {
  Root(const tpetra::Map& map, const Communicator& communicator)
      : shares(map.getNodeNumElements(), communicator),
        unknown(to_root(map.getMyGlobalIndices().data(), MPI_LONG_LONG, shares, communicator)) {}

  Shares shares;                  ///< of a vector, on every rank
  std::vector<GlobalId> unknown;  ///< [n] global numbers in the order in which the ranks' entries arrive
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
  bool ordered = false;  ///< the ordering depends on the pattern only and is found once
};

DirectSolve::DirectSolve(Teuchos::RCP<const tpetra::Matrix> matrix, const Communicator& communicator)
    : OwnedOperator(matrix->getDomainMap()),
      matrix_(std::move(matrix)),
      communicator_(communicator),
      root_(std::make_unique<Root>(*matrix_->getDomainMap(), communicator)) {}

DirectSolve::~DirectSolve() = default;

void DirectSolve::factorise() {
  const auto local = matrix_->getLocalMatrixHost();
  std::vector<GlobalId> row, column;
  for (LocalIndex i = 0; i < local.numRows(); ++i)
    for (auto k = local.graph.row_map(i); k < local.graph.row_map(i + 1); ++k) {
      row.push_back(matrix_->getRowMap()->getGlobalElement(i));
      column.push_back(matrix_->getColMap()->getGlobalElement(local.graph.entries(k)));
    }
  const Shares shares(row.size(), communicator_);
  const auto rows = to_root(row.data(), MPI_LONG_LONG, shares, communicator_);
  const auto columns = to_root(column.data(), MPI_LONG_LONG, shares, communicator_);
  const auto values = to_root(local.values.data(), MPI_DOUBLE, shares, communicator_);

  bool singular = false;
  if (communicator_.is_root()) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      entries.emplace_back(static_cast<int>(rows[k]), static_cast<int>(columns[k]), values[k]);
    Eigen::SparseMatrix<double> whole(root_->shares.total, root_->shares.total);
    whole.setFromTriplets(entries.begin(), entries.end());
    if (!root_->ordered) root_->factors.analyzePattern(whole);
    root_->ordered = true;
    root_->factors.factorize(whole);
    singular = root_->factors.info() != Eigen::Success;
  }
  if (communicator_.any(singular))
    throw std::runtime_error(
        "the direct solver met a singular tangent: a part of the body can move without any force against it");
}

void DirectSolve::multiply(const double* x, double* y) const {
  const Shares& shares = root_->shares;
  std::vector<double> values = to_root(x, MPI_DOUBLE, shares, communicator_);
  if (communicator_.is_root()) {
    Eigen::VectorXd right(shares.total);
    for (std::size_t u = 0; u < values.size(); ++u) right(root_->unknown[u]) = values[u];
    const Eigen::VectorXd left = root_->factors.solve(right);
    for (std::size_t u = 0; u < values.size(); ++u) values[u] = left(root_->unknown[u]);
  }
  MPI_Scatterv(values.data(), shares.count.data(), shares.start.data(), MPI_DOUBLE, y, shares.mine, MPI_DOUBLE, 0,
               communicator_.mpi());
}

}  // namespace perinox::linear
