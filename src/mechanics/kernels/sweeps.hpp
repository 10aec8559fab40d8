#pragma once
/// The sweeps over bonds. Every pair of particles is visited once: the near end's results stay in registers, the far
/// end's are added in memory. Directions are recomputed from the displacement: cheaper than reading them. To be
/// included with PERINOX_KERNELS, the namespace of the instruction set.
#include "lattice_access.hpp"
#include "pair_access.hpp"

namespace perinox::mechanics::kernels::PERINOX_KERNELS {

/// A bond shorter than this, over its reference length, is nothing but the rounding of its ends' places.
constexpr double collapsed = 1e-13;

/// A bond as it stands.
template <int d>
struct Pair {
  Vector bond[d];      ///< Y; small strain: the reference bond
  Vector relative[d];  ///< U
  Vector inverse;      ///< 1/|Y|; small strain: 1/xi; 0 in lanes without a bond
  Vector length;       ///< |Y|; 0 in lanes without a bond
};

/// moved: the displacement matters; without it (the elastic tangent of small strain) none is read.
template <int d, bool small, bool moved = true, class Access>
PERINOX_INLINE Pair<d> pair_of(const Access& far, const Vector* u) {
  Pair<d> p;
  Vector square = {};
  for (int c = 0; c < d; ++c) {
    p.relative[c] = moved ? far.u(c) - u[c] : Vector{};
    p.bond[c] = far.template bond<!small>(c, p.relative[c]);
    if (!small) square += p.bond[c] * p.bond[c];
  }
  p.inverse = far.present(small ? far.inverse_length() : far.inverse_root_of(square));
  p.length = square * p.inverse;
  return p;
}

template <int d>
PERINOX_INLINE Vector dot(const Vector* a, const Vector* b) {
  Vector sum = a[0] * b[0];
  for (int c = 1; c < d; ++c) sum += a[c] * b[c];
  return sum;
}

/// Extension without cancellation: (|Y|^2 - xi^2)/(|Y| + xi) with |Y|^2 - xi^2 = (2 Y - U).U.
template <int d, bool small, class Access>
PERINOX_INLINE Vector extension(const Pair<d>& p, const Access& far) {
  if (small) return dot<d>(p.bond, p.relative) * p.inverse;
  Vector change = {};
  for (int c = 0; c < d; ++c) change += (2 * p.bond[c] - p.relative[c]) * p.relative[c];
  return change / (p.length + far.length());
}

/// The same for the tangent, whose point values only need it to the rounding of |Y|.
template <int d, bool small, class Access>
PERINOX_INLINE Vector rounded_extension(const Pair<d>& p, const Access& far) {
  return small ? dot<d>(p.bond, p.relative) * p.inverse : p.length - far.length();
}

/// Components of a symmetric tensor.
template <int d>
constexpr int components = d*(d + 1) / 2;

template <int d>
PERINOX_INLINE Vector contract(const Vector* a, const Vector* b) {
  Vector sum = a[0] * b[0];
  for (int k = 1; k < components<d>; ++k) sum += a[k] * b[k];
  return sum;
}

// plastic: something has flowed; fitted: an end's strain is fitted. Both for a whole block or near end, whose other
// ends' values are then worthless or zero.

template <int d, bool small, bool plastic, bool fitted>
struct StrainSums {
  static constexpr int results = !fitted   ? (plastic ? 3 : 2)
                                 : plastic ? first_plastic_fit + components<d>
                                           : first_fit + components<d>;
  Vector u[d], mean, sum[results] = {};

  template <class Own>
  PERINOX_INLINE explicit StrainSums(const Own& own) : mean(own.mean()) {
    for (int c = 0; c < d; ++c) u[c] = own.u(c);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small>(far, u);
    Vector e = extension<d, small>(p, far);
    if (!small) {  // a bond that has collapsed has no direction: not a number, which the solver sees and names
      const Lanes sound = p.length > collapsed * far.length();
      e = far.present(sound ? e : all(__builtin_nan("")));
    }
    const Vector near_weight = far.present(far.influence_near() + Vector{});
    const Vector far_weight = far.present(far.influence_far() + Vector{});
    Vector near = e - mean * far.length(), away = e - far.mean() * far.length();
    Vector to_far[results] = {}, xi_n[8];
    if (fitted && far.fitted()) far.template basis<d>(xi_n);
    sum[0] += near_weight * far.length() * e;
    to_far[0] = far_weight * far.length() * e;
    if (fitted && far.fitted())
      for (int k = 0; k < components<d>; ++k) {
        sum[first_fit + k] += near_weight * e * xi_n[k];
        to_far[first_fit + k] = far_weight * e * xi_n[k];
      }
    if (plastic) {
      const Vector near_plastic = load(far.plastic_near()), far_plastic = load(far.plastic_far());
      sum[2] += near_weight * far.length() * near_plastic;
      to_far[2] = far_weight * far.length() * far_plastic;
      if (fitted && far.fitted())
        for (int k = 0; k < components<d>; ++k) {
          sum[first_plastic_fit + k] += near_weight * near_plastic * xi_n[k];
          to_far[first_plastic_fit + k] = far_weight * far_plastic * xi_n[k];
        }
      near -= near_plastic;
      away -= far_plastic;
    }
    sum[1] += near_weight * near * near;
    to_far[1] = far_weight * away * away;
    if (fitted && far.fitted())
      far.template add_far<results>(to_far);
    else
      far.template add_far<plastic ? 3 : 2>(to_far);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<results>(sum);
  }
};

/// Force states of a near end and of the far ends.
template <int d, bool small, bool plastic, bool fitted>
struct BondForce {
  Vector u[d], radial, shear, yielded, state[8];

  template <class Own>
  PERINOX_INLINE explicit BondForce(const Own& own)
      : radial(own.law(Law::radial)), shear(own.law(Law::shear)), yielded(plastic ? own.law(Law::along) : Vector{}) {
    if (fitted) own.template state<d>(state);
    for (int c = 0; c < d; ++c) u[c] = own.u(c);
  }
  /// Sum of both ends' t/omega.
  template <class Access>
  PERINOX_INLINE Vector both_ends(const Pair<d>& p, const Access& far) const {
    const Vector far_shear = far.law(Law::shear);
    Vector t = (radial + far.law(Law::radial)) * far.length() + (shear + far_shear) * extension<d, small>(p, far);
    if (plastic) t -= yielded * load(far.plastic_near()) + far.law(Law::along) * load(far.plastic_far());
    if (fitted && far.fitted()) {
      Vector xi_n[8], both[8];
      far.template basis<d>(xi_n);
      far.template state<d>(both);
      for (int k = 0; k < components<d>; ++k) both[k] += state[k];
      t += contract<d>(both, xi_n);
    }
    return t;
  }
};

template <int d, bool small, bool plastic, bool fitted>
struct Forces {
  const BondForce<d, small, plastic, fitted> bond_force;
  Vector force[d] = {};

  template <class Own>
  PERINOX_INLINE explicit Forces(const Own& own) : bond_force(own) {}
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small>(far, bond_force.u);
    const Vector t = bond_force.both_ends(p, far) * (far.pair() * p.inverse);
    Vector to_far[d];
    for (int c = 0; c < d; ++c) {
      const Vector pull = t * p.bond[c];
      force[c] += pull;
      to_far[c] = -pull;
    }
    far.template add_far<d>(to_far);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<d>(force);
  }
};

/// t (de - M . dU) for the change x of the displacement, de the change of length that it makes. With
/// de = (2 Y + dU) . dU/(|Y| + |Y + dU|) this is t (dU . dU - (M . dU) de)/(|Y| + |Y + dU|): nothing cancels.
template <int d, bool small, bool plastic, bool fitted>
struct TurningWork {
  const BondForce<d, small, plastic, fitted> bond_force;
  Vector x[d], work[1] = {};

  template <class Own>
  PERINOX_INLINE explicit TurningWork(const Own& own) : bond_force(own) {
    for (int c = 0; c < d; ++c) x[c] = own.x(c);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small>(far, bond_force.u);
    Vector along = {}, square = {}, after = {};
    for (int c = 0; c < d; ++c) {
      const Vector step = far.x(c) - x[c], bond = p.bond[c] + step;
      along += p.bond[c] * step;
      square += step * step;
      after += bond * bond;
    }
    const Vector lengths = p.length + after * far.inverse_root_of(after);
    const Vector change = (2 * along + square) / lengths;
    const Vector t = bond_force.both_ends(p, far) * far.pair();
    work[0] += far.present(t * (square - along * p.inverse * change) / lengths);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<1>(work);
  }
};

template <int d, bool small, bool plastic, bool fitted>
struct ProductSums {
  static constexpr bool moved = !small || plastic;
  static constexpr int results = fitted ? first_fit_change + components<d> : plastic ? 2 : 1;
  Vector u[d], x[d], sum[results] = {};

  template <class Own>
  PERINOX_INLINE explicit ProductSums(const Own& own) {
    for (int c = 0; c < d; ++c) u[c] = moved ? own.u(c) : Vector{}, x[c] = own.x(c);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small, moved>(far, u);
    Vector change = {};
    for (int c = 0; c < d; ++c) change += p.bond[c] * (far.x(c) - x[c]);
    change *= p.inverse;
    const Vector near_weight = far.influence_near() * change, far_weight = far.influence_far() * change;
    Vector to_far[results] = {};
    sum[0] += near_weight * far.length();
    to_far[0] = far_weight * far.length();
    if (fitted && far.fitted()) {
      Vector xi_n[8];
      far.template basis<d>(xi_n);
      for (int k = 0; k < components<d>; ++k) {
        sum[first_fit_change + k] += near_weight * xi_n[k];
        to_far[first_fit_change + k] = far_weight * xi_n[k];
      }
    }
    if (plastic) {
      const Vector e = rounded_extension<d, small>(p, far);
      sum[1] += near_weight * (e - load(far.plastic_near()));
      to_far[1] = far_weight * (e - load(far.plastic_far()));
    }
    if (fitted && far.fitted())
      far.template add_far<results>(to_far);
    else
      far.template add_far<plastic ? 2 : 1>(to_far);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<results>(sum);
  }
};

/// dT = dt M + (t/|Y|)(dU - M de).
template <int d, bool small, bool plastic, bool fitted>
struct ProductForces {
  static constexpr bool moved = !small || plastic;
  Vector u[d], x[d], radial, shear, along, flow = {}, yielded = {}, state[8], changed[8], pulled[d] = {};

  template <class Own>
  PERINOX_INLINE explicit ProductForces(const Own& own)
      : radial(small ? Vector{} : own.law(Law::radial)), shear(own.law(Law::shear)), along(own.law(Law::along)) {
    for (int c = 0; c < d; ++c) u[c] = moved ? own.u(c) : Vector{}, x[c] = own.x(c);
    if (plastic) flow = own.law(Law::flow);
    if (plastic && !small) yielded = own.x(3);
    if (fitted && !small) own.template state<d>(state);
    if (fitted) own.template change<d>(changed);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small, moved>(far, u);
    Vector step[d], change = {};
    for (int c = 0; c < d; ++c) {
      step[c] = far.x(c) - x[c];
      change += p.bond[c] * step[c];
    }
    change *= p.inverse;
    const Vector far_shear = far.law(Law::shear), both = shear + far_shear;
    Vector stiff = both * change + (along + far.law(Law::along)) * far.length();
    Vector t = {};
    if (!small || plastic) {
      const Vector e = rounded_extension<d, small>(p, far);
      if (!small) t = (radial + far.law(Law::radial)) * far.length() + both * e;
      if (plastic) {
        const Vector near_plastic = load(far.plastic_near()), far_plastic = load(far.plastic_far());
        if (!small) t -= yielded * near_plastic + far.x(3) * far_plastic;
        stiff += flow * (e - near_plastic) + far.law(Law::flow) * (e - far_plastic);
      }
    }
    if (fitted && far.fitted()) {
      Vector xi_n[8], ends[8];
      far.template basis<d>(xi_n);
      far.template change<d>(ends);
      for (int k = 0; k < components<d>; ++k) ends[k] += changed[k];
      stiff += contract<d>(ends, xi_n);
      if (!small) {
        far.template state<d>(ends);
        for (int k = 0; k < components<d>; ++k) ends[k] += state[k];
        t += contract<d>(ends, xi_n);
      }
    }
    const Vector weight = far.pair() * p.inverse;
    t *= weight;
    const Vector straight = stiff * weight - t * change * p.inverse;
    Vector to_far[d];
    for (int c = 0; c < d; ++c) {
      to_far[c] = straight * p.bond[c];
      if (!small) to_far[c] += t * step[c];
      pulled[c] -= to_far[c];
    }
    far.template add_far<d>(to_far);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<d>(pulled);
  }
};

/// A fitted end's rank-one terms in its neighbours' blocks are those of an isotropic fit: an approximation.
template <int d, bool small, bool plastic, bool fitted>
struct DiagonalBlocks {
  static constexpr bool moved = !small || plastic;
  static constexpr int entries = d * (d + 1) / 2;
  static constexpr int results = fitted ? first_fit_gradient + components<d> * d : entries + d + (plastic ? d : 0);
  Vector u[d], radial, shear, mean, along, flow, yielded, state[8], result[results] = {};

  template <class Own>
  PERINOX_INLINE explicit DiagonalBlocks(const Own& own)
      : radial(small ? Vector{} : own.law(Law::radial)),
        shear(own.law(Law::shear)),
        mean(plastic ? own.mean() : Vector{}),
        along(own.law(Law::along)),
        flow(plastic ? own.law(Law::flow) : Vector{}),
        yielded(plastic && !small ? own.x(3) : Vector{}) {
    for (int c = 0; c < d; ++c) u[c] = moved ? own.u(c) : Vector{};
    if (fitted && !small) own.template state<d>(state);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    const Pair<d> p = pair_of<d, small, moved>(far, u);
    Vector m[d];
    for (int c = 0; c < d; ++c) m[c] = p.bond[c] * p.inverse;
    const Vector far_shear = far.law(Law::shear), both = shear + far_shear;
    const Vector e = moved ? rounded_extension<d, small>(p, far) : Vector{};
    Vector near = e, away = e, t = {};
    Vector near_plastic = {}, far_plastic = {};
    if (plastic) {
      near_plastic = load(far.plastic_near()), far_plastic = load(far.plastic_far());
      near -= near_plastic, away -= far_plastic;
    }
    Vector xi_n[8];
    if (fitted && far.fitted()) far.template basis<d>(xi_n);
    if (!small) {
      t = (radial + far.law(Law::radial)) * far.length() + both * e;
      if (plastic) t -= yielded * near_plastic + far.x(3) * far_plastic;
      if (fitted && far.fitted()) {
        Vector ends[8];
        far.template state<d>(ends);
        for (int k = 0; k < components<d>; ++k) ends[k] += state[k];
        t += contract<d>(ends, xi_n);
      }
      t *= far.pair() * p.inverse;
    }
    // An end's own entry in the other end's rank-one terms.
    const Vector near_state = far.influence_near() * far.length() + Vector{};
    const Vector far_state = far.influence_far() * far.length() + Vector{};
    const Vector straight = both * far.pair() - t;
    Vector to_far = straight + along * near_state * near_state * far.volume_near();
    Vector to_near = straight + far.law(Law::along) * far_state * far_state * far.volume_far();
    if (plastic) {
      near = far.influence_near() * (near - mean * far.length());
      away = far.influence_far() * (away - far.mean() * far.length());
      to_far += flow * near * near * far.volume_near();
      to_near += far.law(Law::flow) * away * away * far.volume_far();
    }
    Vector other[results] = {};
    int k = 0;
    for (int c = 0; c < d; ++c, ++k) {
      result[k] += far.present(to_near * m[c] * m[c] + t);
      other[k] = far.present(to_far * m[c] * m[c] + t);
    }
    for (int c = 0; c < d; ++c)
      for (int b = c + 1; b < d; ++b, ++k) {
        result[k] += to_near * m[c] * m[b];
        other[k] = to_far * m[c] * m[b];
      }
    for (int c = 0; c < d; ++c, ++k) {
      result[k] += near_state * m[c];
      other[k] = -far_state * m[c];
    }
    if (plastic)
      for (int c = 0; c < d; ++c, ++k) {
        result[k] += near * m[c];
        other[k] = -away * m[c];
      }
    if (fitted && far.fitted()) {
      const Vector near_weight = far.influence_near() + Vector{}, far_weight = far.influence_far() + Vector{};
      k = first_fit_gradient;
      for (int b = 0; b < components<d>; ++b)
        for (int c = 0; c < d; ++c, ++k) {
          result[k] += near_weight * xi_n[b] * m[c];
          other[k] = -far_weight * xi_n[b] * m[c];
        }
    }
    if (fitted && far.fitted())
      far.template add_far<results>(other);
    else
      far.template add_far<entries + d + (plastic ? d : 0)>(other);
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own& own) const {
    own.template add<results>(result);
  }
};

template <int d, bool small, bool plastic, bool fitted>
struct Advance {
  Vector u[d], mean, flow;

  template <class Own>
  PERINOX_INLINE explicit Advance(const Own& own) : mean(own.mean()), flow(own.law(Law::flow)) {
    for (int c = 0; c < d; ++c) u[c] = own.u(c);
  }
  template <class Access>
  PERINOX_INLINE void visit(const Access& far) {
    if (!plastic) return;
    const Pair<d> p = pair_of<d, small>(far, u);
    const Vector e = extension<d, small>(p, far);
    const Vector near = load(far.plastic_near()), away = load(far.plastic_far());
    store(far.plastic_near(), near + far.present(flow * (e - mean * far.length() - near)));
    store(far.plastic_far(), away + far.present(far.law(Law::flow) * (e - far.mean() * far.length() - away)));
  }
  template <class Own>
  PERINOX_INLINE void finish(const Own&) const {}
};

template <template <int, bool, bool, bool> class Sweep, int d, bool small, class View>
void run_with(const View& g) {
  run<Sweep<d, small, false, false>, Sweep<d, small, true, false>, Sweep<d, small, false, true>,
      Sweep<d, small, true, true>>(g);
}

template <template <int, bool, bool, bool> class Sweep, class View>
void choose(const View& g, int dimension, bool small) {
  if (dimension == 3)
    small ? run_with<Sweep, 3, true>(g) : run_with<Sweep, 3, false>(g);
  else
    small ? run_with<Sweep, 2, true>(g) : run_with<Sweep, 2, false>(g);
}

/// With small strains no bond turns.
template <class View>
void turning_work(const View& g, int dimension, bool small) {
  if (small) return;
  dimension == 3 ? run_with<TurningWork, 3, false>(g) : run_with<TurningWork, 2, false>(g);
}

template <class View>
Sweeps<View> all_sweeps() {
  return {choose<StrainSums, View>,    choose<Forces, View>,         turning_work<View>,   choose<ProductSums, View>,
          choose<ProductForces, View>, choose<DiagonalBlocks, View>, choose<Advance, View>};
}

}  // namespace perinox::mechanics::kernels::PERINOX_KERNELS
