#pragma once
#include "kernels/instruction_sets.hpp"
#include "perinox/mechanics/family_loops.hpp"

namespace perinox::mechanics {

class PairLoops : public FamilyLoops {
 public:
  PairLoops(const Scene& scene, Purpose purpose);

  void linearise(const double* displacement, const TangentLaw& law, const PlasticExtension& plastic) override;
  void diagonal_blocks(const TangentLaw& law, double* blocks) override;
  void advance(const double* displacement, const double* mean, const double* flow, PlasticExtension& plastic) override;
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
  using Values = std::vector<double>;  ///< [slots * 4]
  static int parts_of(int results) { return (results + 3) / 4; }
  int strain_results() const;
  int product_results() const;
  void clear_results(int count);
  void put_fits(const bonds::Mandel* values, std::array<Values, 2>& to) const;
  bonds::Mandel take_fit(std::size_t m, int first) const;
  void set_fits(kernels::PairView& view) const;
  kernels::PairView view(const std::vector<std::int32_t>& slots, double* const* plastic) const;
  void sweep(kernels::PairSweeps::Sweep run, kernels::PairView view) const { run(view, d_, small_); }
  void both(kernels::PairSweeps::Sweep run, kernels::PairView view) const;
  void put(const double* values, int components, int first, int last, Values& to, int component) const;
  static void set_results(kernels::PairView& view, std::array<Values, 8>& results);
  void take(const Values& from, int component, int components, int first, int last, double* values) const;
  const std::vector<std::int32_t>& slots_of(Bonds bonds) const;
  kernels::PairView force_view(const std::vector<std::int32_t>& slots, const PlasticExtension& plastic);
  kernels::PairView product_view(Bonds bonds);
  std::vector<char> flowing_slots(const Values& values, int component) const;
  void require(Values& values) const;

  const bonds::PairFamilies& families_;
  const std::vector<int>& slot_;
  bool small_;
  bool plastic_body_;  ///< some material flows
  Values reference_;   ///< position, volume
  Values u_, x_, law_;
  std::array<Values, 8> out_;               ///< results, four a slot each
  std::array<Values, 2> state_, change_;    ///< of fits, four components each
  std::vector<std::uint8_t> fitted_slots_;  ///< [owned] not zero where an end of a pair is fitted; empty: nowhere
  Values dilatation_, flow_;                ///< [owned] by slot: coefficients of the tangent's rank-one terms
  std::vector<double*> plastic_;            ///< [owned] for the products; empty: nothing flows or has flowed
  std::vector<double> none_;                ///< the plastic extension of pairs that flow for the first time
};

}  // namespace perinox::mechanics
