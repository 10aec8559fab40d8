#pragma once
#include "kernels/instruction_sets.hpp"
#include "perinox/mechanics/family_loops.hpp"

namespace perinox::mechanics {

/// Arrays over the cells of a grid, each with room before and after for the cells that a stencil reaches beyond it.
class GridArrays {
 public:
  /// The arrays begin at different places of a page: where the same low bits of an address are stored to and loaded
  /// from, the processor waits. Measured: 1.5 instead of 2.8 ns a directed bond.
  /// first: number of these arrays among all that a sweep uses.
  void allocate(int count, std::int64_t cells, std::int64_t guard, int first);
  void release() { memory_ = {}, start_ = {}; }
  bool empty() const { return start_.empty(); }
  double* operator[](int k) { return start_[k]; }
  /// Zeroes an array over the cells, not the room around them.
  void clear(int k);
  std::size_t bytes() const { return memory_.size() * sizeof(double); }
  /// Bytes that allocate() would take.
  static std::size_t bytes_of(int count, std::int64_t cells, std::int64_t guard);

 private:
  std::vector<double> memory_;
  std::vector<double*> start_;
  std::int64_t cells_ = 0;
};

class LatticeLoops : public FamilyLoops {
 public:
  explicit LatticeLoops(const Scene& scene);

  void strain_sums(const double* displacement, const double* shift, const PlasticExtension& plastic,
                   StrainSums& sums) override;
  void forces(const double* radial, const double* shear, const PlasticExtension& plastic, double* force) override;
  void linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) override;
  void product(const double* x, double* y) override;
  void diagonal_blocks(const TangentLaw& law, double* blocks) override;
  void advance(const double* displacement, const double* mean, const double* flow, PlasticExtension& plastic) override;
  LoopMemory expected() const override;
  std::size_t bytes() const override;

 private:
  enum Range { every, interior, boundary };
  kernels::LatticeView view(double* const* plastic, Range range) const;
  std::vector<char> flowing_blocks(const double* flow) const;
  void sweep(kernels::LatticeSweeps::Sweep sweep, kernels::LatticeView view) const;
  void put(const double* values, int components, int first, int last, GridArrays& arrays, int array) const;
  void take(GridArrays& arrays, int array, int components, int first, int last, double* values) const;
  void require(GridArrays& arrays, int count, int first);

  const bonds::LatticeFamilies& families_;
  body::Halo halo_;
  int d_, owned_, local_;
  bool small_;
  bool plastic_body_;  ///< some material flows
  bool moved_;         ///< the tangent depends on the displacement
  std::vector<kernels::Offset> offsets_;
  std::vector<kernels::Block> blocks_;
  std::int64_t guard_ = 0;
  GridArrays u_, x_, law_, mean_, out_;
  std::vector<double> dilatation_, flow_;  ///< [grid] coefficients of the tangent's rank-one terms
  std::vector<double*> plastic_;           ///< [blocks] for the products; empty: nothing flows or has flowed
  std::vector<double> none_;               ///< the plastic extension of a block that flows for the first time
  std::vector<double> ghosts_;             ///< [local * d] of which only ghosts' entries are used
};

}  // namespace perinox::mechanics
