#pragma once
/// How the sweeps reach the points of a lattice: the lanes of a vector are neighbouring cells of a row.
#include "vectors.hpp"
#include "views.hpp"

namespace perinox::mechanics::kernels::PERINOX_KERNELS {

/// cut: particles have parts of their cells' volumes.
template <bool masked, bool cut>
class LatticeAccess {
 public:
  PERINOX_INLINE LatticeAccess(const LatticeView& view, double* e_p, const std::uint8_t* fitted, std::int64_t here,
                               int o, unsigned mask)
      : g_(view),
        o_(view.offsets[o]),
        e_p_(e_p + 2 * group * o),
        fitted_(fitted && fitted[o]),
        here_(here),
        there_(here + o_.cell),
        mask_(mask) {
    // One cache line of plastic extension an end: ask for what comes next before it is needed.
    if (e_p) {
      __builtin_prefetch(e_p_ + 2 * group * 14);
      __builtin_prefetch(e_p_ + 2 * group * 14 + group);
    }
  }

  /// The lanes that have a bond; 0 elsewhere.
  PERINOX_INLINE Vector present(Vector value) const { return masked ? chosen(mask_, value) : value; }
  PERINOX_INLINE Vector u(int c) const { return load(g_.u[c] + there_); }
  PERINOX_INLINE Vector x(int c) const { return load(g_.x[c] + there_); }
  PERINOX_INLINE Vector law(int k) const { return load(g_.law[k] + there_); }
  PERINOX_INLINE Vector mean() const { return load(g_.mean + there_); }

  /// Bond vector before deformation, or, for a tangent of finite deformation, after.
  template <bool current>
  PERINOX_INLINE Vector bond(int c, Vector relative) const {
    return current ? o_.bond[c] + relative : all(o_.bond[c]);
  }
  PERINOX_INLINE double length() const { return o_.length; }
  PERINOX_INLINE Vector inverse_length() const { return all(o_.inverse); }
  PERINOX_INLINE Vector inverse_root_of(Vector square) const {
    return inverse_root(square, o_.inverse * o_.inverse, o_.inverse);
  }
  PERINOX_INLINE auto pair() const {
    if constexpr (cut)
      return o_.pair * part(here_) * part(there_);
    else
      return o_.pair;
  }
  /// Weight of the bond in the sums of the near end, of the far end.
  PERINOX_INLINE auto influence_near() const { return of_part(o_.influence, there_); }
  PERINOX_INLINE auto influence_far() const { return of_part(o_.influence, here_); }
  PERINOX_INLINE bool fitted() const { return fitted_; }
  template <int d>
  PERINOX_INLINE void basis(Vector* xi_n) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) xi_n[k] = all(o_.basis[k]);
  }
  template <int d>
  PERINOX_INLINE void state(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = load(g_.state[k] + there_);
  }
  template <int d>
  PERINOX_INLINE void change(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = load(g_.change[k] + there_);
  }
  PERINOX_INLINE auto volume_near() const { return of_part(g_.volume, here_); }
  PERINOX_INLINE auto volume_far() const { return of_part(g_.volume, there_); }

  PERINOX_INLINE double* plastic_near() const { return e_p_; }
  PERINOX_INLINE double* plastic_far() const { return e_p_ + group; }

  template <int count, int first = 0>
  PERINOX_INLINE void add_far(const Vector* values) const {
    for (int k = 0; k < count; ++k) {
      double* to = g_.out[first + k] + there_;
      store(to, load(to) + values[k]);
    }
  }

 private:
  PERINOX_INLINE Vector part(std::int64_t cell) const { return load(g_.part + cell); }
  PERINOX_INLINE auto of_part(double whole, std::int64_t cell) const {
    if constexpr (cut)
      return whole * part(cell);
    else
      return whole;
  }

  const LatticeView& g_;
  const Offset& o_;
  double* e_p_;
  bool fitted_;
  std::int64_t here_, there_;
  unsigned mask_;
};

/// The near end: a vector of cells.
class LatticeOwn {
 public:
  PERINOX_INLINE LatticeOwn(const LatticeView& view, std::int64_t here) : g_(view), here_(here) {}
  PERINOX_INLINE Vector u(int c) const { return load(g_.u[c] + here_); }
  PERINOX_INLINE Vector x(int c) const { return load(g_.x[c] + here_); }
  PERINOX_INLINE Vector law(int k) const { return load(g_.law[k] + here_); }
  PERINOX_INLINE Vector mean() const { return load(g_.mean + here_); }
  template <int d>
  PERINOX_INLINE void state(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = load(g_.state[k] + here_);
  }
  template <int d>
  PERINOX_INLINE void change(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = load(g_.change[k] + here_);
  }
  template <int count, int first = 0>
  PERINOX_INLINE void add(const Vector* values) const {
    for (int k = 0; k < count; ++k) {
      double* to = g_.out[first + k] + here_;
      store(to, load(to) + values[k]);
    }
  }

 private:
  const LatticeView& g_;
  std::int64_t here_;
};

/// One vector of cells: own values loaded, every offset, own results stored.
template <class Sweep, bool cut = false>
PERINOX_INLINE void visit_cells(const LatticeView& g, const Block& block, double* e_p, const std::uint8_t* fitted,
                                int lane) {
  const std::int64_t here = block.cell + lane;
  const LatticeOwn own(g, here);
  Sweep sweep(own);
  if (block.mask < 0) {
    for (int o = 0; o < g.offset_count; ++o) sweep.visit(LatticeAccess<false, cut>(g, e_p, fitted, here, o, 0));
  } else {
    for (int o = 0; o < g.offset_count; ++o) {
      const unsigned mask = (static_cast<unsigned>(g.masks[block.mask + o]) >> lane) & ((1u << width) - 1);
      if (mask) sweep.visit(LatticeAccess<true, cut>(g, e_p, fitted, here, o, mask));
    }
  }
  sweep.finish(own);
}

/// All blocks; those where something has flowed carry the plastic terms, those with fitted ends the fit's.
template <class Plain, class Flowed, class Fitted, class FittedFlowed>
void run(const LatticeView& g) {
  for (std::int64_t b = 0; b < g.block_count; ++b) {
    double* e_p = g.plastic ? g.plastic[b] : nullptr;
    const std::uint8_t* fitted = g.fitted && g.fitted[b] >= 0 ? g.fit_marks + g.fitted[b] : nullptr;
    for (int lane = 0; lane < group; lane += width) {
      double* from = e_p ? e_p + lane : nullptr;
      const Block& block = g.blocks[b];
      if (fitted && g.part)
        e_p ? visit_cells<FittedFlowed, true>(g, block, from, fitted, lane)
            : visit_cells<Fitted, true>(g, block, from, fitted, lane);
      else if (fitted)
        e_p ? visit_cells<FittedFlowed>(g, block, from, fitted, lane)
            : visit_cells<Fitted>(g, block, from, fitted, lane);
      else
        e_p ? visit_cells<Flowed>(g, block, from, nullptr, lane) : visit_cells<Plain>(g, block, from, nullptr, lane);
    }
  }
}

}  // namespace perinox::mechanics::kernels::PERINOX_KERNELS
