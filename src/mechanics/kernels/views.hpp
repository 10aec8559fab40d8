#pragma once
/// What the sweeps over bonds see: plain pointers. The sweeps are compiled once for each instruction set, so these
/// headers include nothing that could leave an inline function of the standard library compiled for the wrong machine.
#include <cstdint>

namespace perinox::mechanics::kernels {

/// Cells of a block of lattice cells, pairs of a group: the lanes of the widest vector.
constexpr int group = 8;

/// Components of the sums that a fit of the strain takes, in 3-D; 3 in 2-D.
constexpr int fit_size = 6;
/// Results of a sweep at most: diagonal blocks with a fit and plastic flow.
constexpr int most_results = 30;

/// One offset of the half stencil. It stands for the bond to the cell `cell` further on and for the reverse bond.
struct Offset {
  std::int64_t cell = 0;
  double bond[3] = {};          ///< reference bond vector, length
  double length = 0;            ///< xi
  double inverse = 0;           ///< 1/xi
  double pair = 0;              ///< omega s V^2, s the quadrature's share of the volume
  double radial = 0;            ///< omega xi s V
  double influence = 0;         ///< omega s V
  double basis[fit_size] = {};  ///< xi N, N = n (x) n in Mandel's notation
};

/// Eight cells of a row with at least one bond of the half stencil.
struct Block {
  std::int64_t cell = 0;
  std::int64_t mask = -1;  ///< first of the block's masks, one byte an offset, one bit a lane; -1: every bond is there
};

/// Bonds of a lattice. Point values are one array a component over the cells, zero where no particle is.
struct LatticeView {
  const Offset* offsets = nullptr;
  int offset_count = 0;
  const Block* blocks = nullptr;
  std::int64_t block_count = 0;
  const std::uint8_t* masks = nullptr;
  /// [blocks] plastic extension, [offsets][near end's family, far end's][group]; null where neither end has flowed yet.
  /// Null as a whole: nothing has flowed anywhere.
  double* const* plastic = nullptr;
  /// [blocks] first of the block's marks, one an offset, not zero where an end of a bond has its strain fitted; -1: no
  /// end has. Null: nowhere.
  const std::int64_t* fitted = nullptr;
  const std::uint8_t* fit_marks = nullptr;
  double volume = 0;  ///< of a whole cell
  /// What particles have of a cell's volume, the same in every block that is not fitted; null: all of it everywhere.
  const double* part = nullptr;

  const double* u[3] = {};       ///< displacement
  const double* x[4] = {};       ///< what a product is taken with; then, not for small strain, `yielded` of Law
  const double* law[4] = {};     ///< Law below
  const double* mean = nullptr;  ///< theta/d, of the shift or of the state
  /// Of fitted ends, zero elsewhere: H of the force state, t = omega (shear e - yielded e_p + xi N . H), and what a
  /// product changes it by.
  const double* state[fit_size] = {};
  const double* change[fit_size] = {};
  double* out[most_results] = {};
};

/// Bonds of any body, as pairs kept with their near end. Point values are four doubles a slot.
struct PairView {
  const std::int32_t* slots = nullptr;  ///< [slot_count] near ends to visit
  std::int64_t slot_count = 0;
  const std::int64_t* begin = nullptr;  ///< [slot] first pair
  const std::int32_t* far = nullptr;    ///< [pairs] slot of the far end
  const double* length = nullptr;       ///< [pairs]
  const double* weight = nullptr;       ///< [pairs] omega s; null: 1
  double* const* plastic = nullptr;     ///< [slots] plastic extension, [pairs/group][near, far][group]; null as above

  const std::uint8_t* fitted = nullptr;  ///< [slots] not zero where an end of a pair is fitted
  const double* place = nullptr;  ///< reference position, then volume; for the tangent of finite deformation: position
  const double* u = nullptr;      ///< displacement, then mean
  const double* x = nullptr;      ///< what a product is taken with, fourth as above
  const double* law = nullptr;
  const double* state[2] = {};   ///< H as above, components 0-3 and 4-7
  const double* change[2] = {};  ///< the same
  double* out[8] = {};           ///< results 0-3, 4-7 and so on
};

/// Point values of the law, t = omega (radial xi + shear e - yielded e_p); `yielded` is `shear` without kinematic
/// hardening.
enum Law {
  shear = 0,
  along = 1,  ///< forces: `yielded`; product: c1 Theta - mean c2 Q; diagonal blocks: c1
  flow = 2,   ///< product: c2 Q; diagonal blocks: c2; advance: share of the elastic part that flows
  radial = 3  ///< not read by the tangent of small strain, which has no geometric term
};

/// The sweeps of one instruction set. `small`: bonds keep their reference direction.
/// Numbers of results.
constexpr int first_fit = 3, first_plastic_fit = first_fit + fit_size, first_fit_change = 2, first_fit_gradient = 12;

template <class View>
struct Sweeps {
  using Sweep = void (*)(const View&, int dimension, bool small);
  /// out: (omega xi) . e; sum omega (e - e_p - mean xi)^2 weight; (omega xi) . e_p; around fitted ends sum omega xi N e
  /// weight, and from first_plastic_fit on the same of e_p.
  Sweep strain_sums = nullptr;
  /// out: internal force.
  Sweep forces = nullptr;
  /// x: a step. out: at the near end, its bonds' work along their change of length less that along the step's chord,
  /// t (de - M . dU). Nothing with small strain.
  Sweep turning_work = nullptr;
  /// out: (omega xi) . de; (omega (e - e_p)) . de; around fitted ends sum omega xi N de weight.
  Sweep product_sums = nullptr;
  /// out: K x.
  Sweep product_forces = nullptr;
  /// out: the diagonal block without the particle's own rank-one terms, xx yy zz xy xz yz (2-D: xx yy xy);
  /// then sum omega xi weight M and sum omega (e - e_p - mean xi) weight M; around fitted ends, from
  /// first_fit_gradient on, sum omega xi N weight M, component by component of N.
  Sweep diagonal_blocks = nullptr;
  /// Writes through the view's plastic extension: e_p += flow (e - mean xi - e_p).
  Sweep advance = nullptr;
};
using LatticeSweeps = Sweeps<LatticeView>;
using PairSweeps = Sweeps<PairView>;

}  // namespace perinox::mechanics::kernels
