#pragma once
#include "grid_arrays.hpp"
#include "kernels/instruction_sets.hpp"
#include "perinox/mechanics/family_loops.hpp"

namespace perinox::mechanics {

class LatticeLoops : public FamilyLoops {
 public:
  LatticeLoops(const Scene& scene, Purpose purpose);

  void linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) override;
  void diagonal_blocks(const TangentLaw& law, double* blocks) override;
  void advance(const double* displacement, const double* mean, const double* flow, PlasticExtension& plastic) override;
  void bonds_changed() override;
  LoopMemory expected() const override;
  std::size_t bytes() const override;

 protected:
  void begin_strains(const double* shift) override;
  void put_displacement(const double* displacement, LocalIndex first, LocalIndex last) override;
  void sweep_strains(Bonds bonds, const PlasticExtension& plastic) override;
  void take_strains(bool flowed, StrainSums& sums) const override;
  void begin_forces(const double* radial, const double* shear, const double* yielded,
                    const bonds::Mandel* state) override;
  void sweep_forces(Bonds bonds, const PlasticExtension& plastic) override;
  double sweep_turning(const PlasticExtension& plastic, const double* step) override;
  void put_direction(const double* x, LocalIndex first, LocalIndex last) override;
  void clear_sums() override;
  void product_sums(Bonds bonds) override;
  void product_law() override;
  void product_forces(Bonds bonds) override;
  void take_forces(LocalIndex first, LocalIndex last, double* y) const override;

 private:
  enum Range { every, interior, boundary };
  kernels::LatticeView view(double* const* plastic, Range range) const;
  static Range range_of(Bonds bonds) { return bonds == Bonds::inner ? interior : boundary; }
  kernels::LatticeView force_view(const PlasticExtension& plastic, Range range) const;
  kernels::LatticeView product_view(Bonds bonds) const;
  std::vector<char> flowing_blocks(const double* flow) const;
  void sweep(kernels::LatticeSweeps::Sweep sweep, kernels::LatticeView view) const;
  void put(const double* values, int components, int first, int last, GridArrays& arrays, int array) const;
  void take(const GridArrays& arrays, int array, int components, int first, int last, double* values) const;
  void require(GridArrays& arrays, int count, int first);
  void put_yielded(const double* values);
  const double* yielded_of_tangent() const;
  void put_fits(const bonds::Mandel* values, GridArrays& arrays, int first);
  bonds::Mandel take_fit(std::size_t m, int array) const;
  /// Which particles have parts of their cells only. volumes: [local].
  void find_parts(const std::vector<double>& volumes);
  void find_fitted_blocks();
  double volume_of(LocalIndex i) const;
  int strain_results() const;
  int product_results() const;

  const bonds::LatticeFamilies& families_;
  bool small_;
  bool plastic_body_;  ///< some material flows
  bool moved_;         ///< the tangent depends on the displacement
  std::vector<kernels::Offset> offsets_;
  std::vector<kernels::Block> blocks_;
  std::int64_t guard_ = 0;
  std::vector<std::int64_t> fitted_blocks_;  ///< [blocks] first of the marks around fitted particles, or -1
  std::vector<std::uint8_t> fit_marks_;      ///< one an offset; empty: nothing is fitted
  GridArrays u_, x_, law_, mean_, state_, change_, out_;
  GridArrays yielded_;                     ///< empty without kinematic hardening
  GridArrays part_;                        ///< what particles have of a cell's volume; empty: all of it everywhere
  bool fits_ = false;                      ///< some block is fitted, or has parts of cells
  std::vector<double> dilatation_, flow_;  ///< [grid] coefficients of the tangent's rank-one terms
  std::vector<double*> plastic_;           ///< [blocks] for the products; empty: nothing flows or has flowed
  std::vector<double> none_;               ///< the plastic extension of a block that flows for the first time
};

}  // namespace perinox::mechanics
