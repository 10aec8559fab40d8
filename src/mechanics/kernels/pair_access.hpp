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

template <class Elastic, class Plastic>
void run(const PairView& g) {
  for (std::int64_t s = 0; s < g.slot_count; ++s) {
    const int near = g.slots[s];
    double* e_p = g.plastic ? g.plastic[near] : nullptr;
    if (e_p)
      visit_particle<Plastic>(g, near, e_p);
    else
      visit_particle<Elastic>(g, near, nullptr);
  }
}

}  // namespace perinox::mechanics::kernels::PERINOX_KERNELS
