#pragma once
/// How the sweeps reach the points of any body: the lanes of a vector are the far ends of one particle's pairs.
#include "vectors.hpp"
#include "views.hpp"

namespace perinox::mechanics::kernels::PERINOX_KERNELS {

class PairAccess {
 public:
  PERINOX_INLINE PairAccess(const PairView& view, int near, std::int64_t pair, double* e_p)
      : g_(view), near_(near), pair_(pair), far_(view.far + pair), e_p_(e_p) {
    gather(g_.place, far_, place_);
    gather(g_.u, far_, u_);
    gather(g_.x, far_, x_);
    gather(g_.law, far_, law_);
    weight_ = view.weight ? load(view.weight + pair) : all(1);
  }

  PERINOX_INLINE Vector present(Vector value) const { return value; }  // the volume of what is not there is zero
  PERINOX_INLINE Vector u(int c) const { return u_[c]; }
  PERINOX_INLINE Vector x(int c) const { return x_[c]; }
  PERINOX_INLINE Vector law(int k) const { return law_[k]; }
  PERINOX_INLINE Vector mean() const { return u_[3]; }

  template <bool current>
  PERINOX_INLINE Vector bond(int c, Vector relative) const {
    const Vector bond = place_[c] - g_.place[4 * near_ + c];
    return current ? bond + relative : bond;
  }
  PERINOX_INLINE Vector length() const { return load(g_.length + pair_); }
  PERINOX_INLINE Vector inverse_length() const { return 1 / length(); }
  PERINOX_INLINE Vector inverse_root_of(Vector square) const {
    const Vector inverse = inverse_length();
    return inverse_root(square, inverse * inverse, inverse);
  }
  PERINOX_INLINE Vector pair() const { return weight_ * volume_near() * volume_far(); }
  PERINOX_INLINE Vector influence_near() const { return weight_ * volume_far(); }
  PERINOX_INLINE Vector influence_far() const { return weight_ * volume_near(); }
  PERINOX_INLINE bool fitted() const { return true; }
  template <int d>
  PERINOX_INLINE void basis(Vector* xi_n) const {
    constexpr double root2 = 1.4142135623730951;
    Vector bond[d];
    for (int c = 0; c < d; ++c) bond[c] = place_[c] - g_.place[4 * near_ + c];
    const Vector inverse = inverse_length();
    for (int c = 0; c < d; ++c) xi_n[c] = bond[c] * bond[c] * inverse;
    if (d == 2)
      xi_n[2] = root2 * bond[0] * bond[1] * inverse;
    else
      for (int c = 0; c < d; ++c) xi_n[d + c] = root2 * bond[(c + 1) % d] * bond[(c + 2) % d] * inverse;
  }
  template <int d>
  PERINOX_INLINE void state(Vector* to) const {
    for (int part = 0; 4 * part < d * (d + 1) / 2; ++part) gather(g_.state[part], far_, to + 4 * part);
  }
  template <int d>
  PERINOX_INLINE void change(Vector* to) const {
    for (int part = 0; 4 * part < d * (d + 1) / 2; ++part) gather(g_.change[part], far_, to + 4 * part);
  }
  PERINOX_INLINE double volume_near() const { return g_.place[4 * near_ + 3]; }
  PERINOX_INLINE Vector volume_far() const { return place_[3]; }

  PERINOX_INLINE double* plastic_near() const { return e_p_; }
  PERINOX_INLINE double* plastic_far() const { return e_p_ + group; }

  template <int count, int first = 0>
  PERINOX_INLINE void add_far(const Vector* values) const {
    for (int part = 0; part < count; part += 4)
      scatter(g_.out[(first + part) / 4], far_, values + part, count - part < 4 ? count - part : 4);
  }

 private:
  const PairView& g_;
  int near_;
  std::int64_t pair_;
  const std::int32_t* far_;
  double* e_p_;
  Vector place_[4], u_[4], x_[4], law_[4], weight_;
};

/// The near end: one particle, the same in all lanes.
class PairOwn {
 public:
  PERINOX_INLINE PairOwn(const PairView& view, int near) : g_(view), near_(near) {}
  PERINOX_INLINE Vector u(int c) const { return all(g_.u[4 * near_ + c]); }
  PERINOX_INLINE Vector x(int c) const { return all(g_.x[4 * near_ + c]); }
  PERINOX_INLINE Vector law(int k) const { return all(g_.law[4 * near_ + k]); }
  PERINOX_INLINE Vector mean() const { return all(g_.u[4 * near_ + 3]); }
  template <int d>
  PERINOX_INLINE void state(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = all(g_.state[k / 4][4 * near_ + k % 4]);
  }
  template <int d>
  PERINOX_INLINE void change(Vector* to) const {
    for (int k = 0; k < d * (d + 1) / 2; ++k) to[k] = all(g_.change[k / 4][4 * near_ + k % 4]);
  }
  template <int count, int first = 0>
  PERINOX_INLINE void add(const Vector* values) const {
    for (int k = 0; k < count; ++k) g_.out[(first + k) / 4][4 * near_ + (first + k) % 4] += total(values[k]);
  }

 private:
  const PairView& g_;
  int near_;
};

template <class Sweep>
PERINOX_INLINE void visit_particle(const PairView& g, int near, double* e_p) {
  const PairOwn own(g, near);
  Sweep sweep(own);
  const std::int64_t begin = g.begin[near], end = g.begin[near + 1];
  for (std::int64_t pair = begin; pair < end; pair += width) {
    const std::int64_t k = pair - begin;
    sweep.visit(PairAccess(g, near, pair, e_p + k / group * 2 * group + k % group));
  }
  sweep.finish(own);
}

template <class Plain, class Flowed, class Fitted, class FittedFlowed>
void run(const PairView& g) {
  for (std::int64_t s = 0; s < g.slot_count; ++s) {
    const int near = g.slots[s];
    double* e_p = g.plastic ? g.plastic[near] : nullptr;
    const bool fitted = g.fitted && g.fitted[near];
    if (e_p)
      fitted ? visit_particle<FittedFlowed>(g, near, e_p) : visit_particle<Flowed>(g, near, e_p);
    else
      fitted ? visit_particle<Fitted>(g, near, nullptr) : visit_particle<Plain>(g, near, nullptr);
  }
}

}  // namespace perinox::mechanics::kernels::PERINOX_KERNELS
