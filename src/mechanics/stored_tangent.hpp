#pragma once
#include <cstdint>
#include <vector>

#include "perinox/mechanics/tangent.hpp"

namespace perinox::mechanics {

/// The tangent with its linearisation stored bond by bond: for the family of i,
///     dT = dt M + (t/|Y|)(I - M M) dU,   dt = D de + sum_r c_r p_r (q_r . de),   de = M . dU
/// (Eq. 26, 65). The sparse assembly reads these arrays, and the printed form of the literature, which is no sum of
/// point terms, has no other. About 60 bytes a directed bond.
class StoredTangent : public Tangent {
 public:
  explicit StoredTangent(const Scene& scene);

  bool linearise(const Committed& committed, const medium::At& at, deck::TangentForm form) override;
  void apply(const double* x, double* y) const override;
  void diagonal_blocks(double* blocks, double dilatation = 1) const override;
  std::size_t bytes() const override;

  // Linearisation data, read by the sparse assembly.
  struct Term {
    double coefficient = 0;
    const double* p = nullptr;  ///< [family]; null: omega xi
    const double* q = nullptr;
  };
  const double* direction(std::int64_t bond) const {
    return &direction_[static_cast<std::size_t>(bond) * static_cast<std::size_t>(scene_.dimension())];
  }
  double diagonal(std::int64_t bond) const { return diagonal_[bond]; }
  /// t/|Y|, force a volume squared and length.
  double geometric(std::int64_t bond) const { return geometric_[bond]; }
  int rank(LocalIndex i) const { return static_cast<int>(term_begin_[i + 1] - term_begin_[i]); }
  const Term& term(LocalIndex i, int r) const { return terms_[term_begin_[i] + r]; }
  /// omega xi of a bond where the pointer of a term is null.
  static double entry(const double* state, const bonds::Bonds& bonds, std::int64_t first, int j) {
    return state ? state[j] : bonds.influence[first + j] * bonds.length[first + j];
  }

 private:
  template <int d>
  void linearise_points(const Committed& committed, deck::TangentForm form);
  template <int d>
  void apply_points(double* y) const;
  template <int d>
  void block_points(double* blocks, double dilatation) const;
  double* keep(const double* values, int count);

  std::vector<double> direction_;         ///< [bonds * d] M
  std::vector<double> diagonal_;          ///< [bonds] D
  std::vector<double> geometric_;         ///< [bonds] t/|Y|
  std::vector<std::int64_t> term_begin_;  ///< [owned + 1]
  std::vector<Term> terms_;
  std::vector<std::vector<double>> pool_;  ///< storage of the terms' states, in blocks that never move
  std::size_t pool_block_ = 0, pool_used_ = 0;
  mutable std::vector<double> x_, y_;  ///< [local * d] with ghosts
};

}  // namespace perinox::mechanics
