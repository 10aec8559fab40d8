/// The coarse system, small: gathered and factorised on every rank.
#include <algorithm>

#include "block_factors.hpp"
#include "coarse_solver.hpp"

namespace perinox::linear {

namespace {

class Factors : public CoarseSolver {
 public:
  Factors(const Communicator& ranks, const std::vector<GlobalId>& node_ids, const CoarseMatrix& matrix)
      : ranks_(ranks) {
    const auto d = static_cast<std::size_t>(matrix.dimension);
    // Numbers of the nodes among all ranks' nodes, in the order of their ids: the factors do not depend on the
    // partition.
    std::vector<long long> ids = node_ids;
    if (ranks.size() > 1) {
      ids = ranks.gather(ids);
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    }
    for (const GlobalId id : node_ids)
      number_.push_back(static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()));
    dimension_ = d;

    std::vector<long long> places;  // row * nodes + column of each block of the lower half
    std::vector<double> blocks;
    for (std::size_t row = 0; row + 1 < matrix.row_begin.size(); ++row)
      for (std::size_t k = matrix.row_begin[row]; k < matrix.row_begin[row + 1]; ++k) {
        const std::size_t column = number_[static_cast<std::size_t>(matrix.column[k])];
        if (column > number_[row]) continue;
        places.push_back(static_cast<long long>(number_[row] * ids.size() + column));
        blocks.insert(blocks.end(), &matrix.value[k * d * d], &matrix.value[k * d * d] + d * d);
      }
    if (ranks.size() > 1) {
      places = ranks.gather(places);
      blocks = ranks.gather(blocks);
    }
    std::vector<BlockFactors::Place> lower;
    lower.reserve(places.size());
    for (const long long place : places)
      lower.push_back({static_cast<LocalIndex>(static_cast<std::size_t>(place) / ids.size()),
                       static_cast<LocalIndex>(static_cast<std::size_t>(place) % ids.size())});
    factors_ = std::make_unique<BlockFactors>(matrix.dimension, ids.size(), lower, blocks);
    all_.resize(factors_->size());
    unknowns_ = static_cast<long long>(ids.size() * d);
  }

  void solve(const double* right, double* solution) override {
    const std::size_t d = dimension_;
    std::fill(all_.begin(), all_.end(), 0.0);
    for (std::size_t n = 0; n < number_.size(); ++n)
      for (std::size_t c = 0; c < d; ++c) all_[factors_->at(number_[n]) + c] = right[n * d + c];
    if (ranks_.size() > 1) ranks_.sum(all_);
    factors_->solve(all_.data());
    for (std::size_t n = 0; n < number_.size(); ++n)
      for (std::size_t c = 0; c < d; ++c) solution[n * d + c] = all_[factors_->at(number_[n]) + c];
  }
  bool exact() const override { return true; }
  long long unknowns() const override { return unknowns_; }
  std::size_t bytes() const override { return factors_->bytes(); }

 private:
  Communicator ranks_;
  std::size_t dimension_ = 3;
  std::vector<std::size_t> number_;  ///< [nodes of this rank] among all nodes
  std::unique_ptr<BlockFactors> factors_;
  std::vector<double> all_;
  long long unknowns_ = 0;
};

}  // namespace

std::unique_ptr<CoarseSolver> factorised_coarse_solver(const Communicator& ranks, const std::vector<GlobalId>& node_ids,
                                                       const CoarseMatrix& matrix) {
  return std::make_unique<Factors>(ranks, node_ids, matrix);
}

}  // namespace perinox::linear
