/// Compares the library's force and modulus states with derivatives, exact to rounding, of a second implementation. It
/// has one scalar potential, written straight from the formulas and differentiated once and twice by Sacado, and a
/// force state written straight from Mitchell's Eq. 24, 28, 40-45 and differentiated by complex steps.
#include <gtest/gtest.h>

#include <Sacado.hpp>
#include <complex>
#include <tuple>

#include "support/material_table.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

using First = Sacado::Fad::DFad<double>;
using Second = Sacado::Fad::DFad<First>;
using Complex = std::complex<double>;

double plain(double x) { return x; }
double plain(const Complex& x) { return x.real(); }
template <class T>
double plain(const Sacado::Fad::DFad<T>& x) {
  return plain(x.val());
}

/// What the second implementation needs to know.
struct Problem {
  const RandomFamily* family;
  YieldSurface surface;  ///< stress zero: elastic
  double kappa;
  Vector plastic_extension;
  double plastic_shear;                                         ///< gamma_p before the step
  double overlay() const { return surface.kinematic / shear; }  ///< h = H_k/mu; plastic_extension is (1 + h) e_p

  double alpha() const { return family->dimension * (family->dimension + 2) * shear / family->weighted_volume; }
  double yield_scale() const {
    return std::sqrt(family->dimension * (family->dimension + 2) /
                     (surface.continuum ? family->continuum_weighted_volume : family->weighted_volume));
  }
};

template <class Scalar>
Scalar dilatation(const Problem& problem, const std::vector<Scalar>& extension) {
  const RandomFamily& f = *problem.family;
  Scalar sum = 0.0;
  for (std::size_t j = 0; j < extension.size(); ++j) sum += f.influence[j] * f.length[j] * f.weight[j] * extension[j];
  return sum * (f.dimension / f.weighted_volume);
}

template <class Scalar>
std::vector<Scalar> trial_state(const Problem& problem, const std::vector<Scalar>& extension) {
  const RandomFamily& f = *problem.family;
  const Scalar theta = dilatation(problem, extension);
  std::vector<Scalar> trial(extension.size());
  for (std::size_t j = 0; j < extension.size(); ++j)
    trial[j] = problem.alpha() * f.influence[j] *
               (extension[j] - theta * (f.length[j] / f.dimension) - problem.plastic_extension[j]);
  return trial;
}

template <class Scalar>
Scalar trial_norm(const Problem& problem, const std::vector<Scalar>& trial) {
  using std::sqrt;
  Scalar square = 0.0;
  for (std::size_t j = 0; j < trial.size(); ++j)
    if (problem.family->influence[j] > 0)
      square += trial[j] * trial[j] * (problem.family->weight[j] / problem.family->influence[j]);
  return sqrt(square);
}

/// The norm alpha sqrt(sum omega e_d^2 weight).
template <class Scalar>
Scalar total_norm(Problem problem, const std::vector<Scalar>& extension) {
  problem.plastic_extension.assign(extension.size(), 0.0);
  return trial_norm(problem, trial_state(problem, extension));
}

/// The yield value beta(N) while N grows: constant, or linear with the slope H/(H + alpha/c^2).
struct Surface {
  explicit Surface(const Problem& p)
      : start(p.yield_scale() * (p.surface.stress + p.surface.hardening * p.plastic_shear)),
        slope(p.surface.hardening /
              (p.surface.hardening + (1 + p.overlay()) * p.alpha() / (p.yield_scale() * p.yield_scale()))) {}
  double start, slope;
};

/// The potential kappa theta^2/2 plus the deviatoric part, which is quadratic in N below the surface and the integral
/// of beta/alpha dN beyond it.
template <class Scalar>
Scalar potential(const Problem& problem, const std::vector<Scalar>& extension) {
  const Scalar theta = dilatation(problem, extension);
  const Scalar norm = trial_norm(problem, trial_state(problem, extension));
  const double h = problem.overlay(), inner = (1 + h) * problem.alpha();
  const Scalar total = total_norm(problem, extension);
  const Scalar volumetric = 0.5 * problem.kappa * theta * theta + h * total * total / (2 * inner);
  const Surface surface(problem);
  if (problem.surface.stress == 0 || plain(norm) <= surface.start) return volumetric + norm * norm / (2 * inner);
  const Scalar beyond = norm - surface.start;
  return volumetric +
         (0.5 * surface.start * surface.start + surface.start * beyond + 0.5 * surface.slope * beyond * beyond) / inner;
}

template <class Scalar>
std::vector<Scalar> force_state(const Problem& problem, const std::vector<Scalar>& extension) {
  const RandomFamily& f = *problem.family;
  const Scalar theta = dilatation(problem, extension);
  std::vector<Scalar> state = trial_state(problem, extension);
  const double h = problem.overlay();
  Problem elastic = problem;
  elastic.plastic_extension.assign(extension.size(), 0.0);
  const std::vector<Scalar> parallel = trial_state(elastic, extension);
  const Scalar norm = trial_norm(problem, state);
  const Surface surface(problem);
  const bool flows = problem.surface.stress > 0 && plain(norm) > surface.start;
  const Scalar scale = flows ? (surface.start + surface.slope * (norm - surface.start)) / norm : Scalar(1.0);
  for (std::size_t j = 0; j < state.size(); ++j)
    state[j] = (scale * state[j] + h * parallel[j]) / (1 + h) +
               theta * (f.dimension * problem.kappa / f.weighted_volume * f.influence[j] * f.length[j]);
  return state;
}

class AutomaticDerivative : public ::testing::TestWithParam<std::tuple<MaterialRow, LoadPath>> {
 protected:
  static constexpr int bonds = 16;
  AutomaticDerivative()
      : row_(std::get<0>(GetParam())),
        material_(row_.make()),
        family_(random_family(row_.dimension, deck::Influence::polynomial, bonds, 3)),
        point_(*material_, family_) {
    const auto& stops = std::get<1>(GetParam()).stops;
    for (std::size_t s = 0; s < stops.size(); ++s) {
      extension_ = random_extension(family_, stops[s].shear * yield_strain, 0.5 * yield_strain, stops[s].direction);
      if (s + 1 < stops.size()) point_.commit(point_.evaluate(extension_));
    }
    problem_.family = &family_;
    problem_.kappa = row_.dimension == 3 ? bulk : bulk + shear / 3;
    problem_.plastic_extension.assign(bonds, 0.0);
    problem_.plastic_shear = 0;
    if (!row_.surface.empty()) {
      problem_.surface = row_.surface[0];
      problem_.plastic_extension = point_.committed_bond();
      problem_.plastic_shear = std::sqrt(3.0) * point_.committed_point().at(1);
    }
  }

  /// Rows of the library's modulus state: dt_i/de_j.
  std::vector<Vector> library_modulus() const {
    const materials::ModulusState modulus = point_.modulus(extension_);
    std::vector<Vector> rows(bonds, Vector(bonds));
    for (int j = 0; j < bonds; ++j) {
      Vector unit(bonds, 0.0);
      unit[j] = 1;
      const Vector column = point_.apply(modulus, unit);
      for (int i = 0; i < bonds; ++i) rows[i][j] = column[i];
    }
    return rows;
  }
  static double difference(const std::vector<Vector>& found, const std::vector<Vector>& expected) {
    Vector a, b;
    for (const Vector& row : found) a.insert(a.end(), row.begin(), row.end());
    for (const Vector& row : expected) b.insert(b.end(), row.begin(), row.end());
    return relative_difference(a, b);
  }

  MaterialRow row_;
  std::unique_ptr<materials::Material> material_;
  RandomFamily family_;
  MaterialPoint point_;
  Vector extension_;
  Problem problem_{};
};

TEST_P(AutomaticDerivative, PotentialOnceAndTwice) {
  std::vector<Second> extension;
  for (int j = 0; j < bonds; ++j) {
    Second e(bonds, j, First(bonds, j, extension_[j]));
    extension.push_back(e);
  }
  const Second value = potential(problem_, extension);
  const Evaluation library = point_.evaluate(extension_);
  EXPECT_LE(measured("materials: potential against the second implementation",
                     std::abs(library.potential() / plain(value) - 1)),
            1e-12);  // 5.6e-16
  Vector force(bonds);
  std::vector<Vector> modulus(bonds, Vector(bonds));
  for (int i = 0; i < bonds; ++i) {
    force[i] = value.dx(i).val() / family_.weight[i];
    for (int j = 0; j < bonds; ++j) modulus[i][j] = value.dx(i).dx(j) / family_.weight[i];
  }
  EXPECT_LE(measured("materials: t against Sacado", relative_difference(library.force_state, force)),
            1e-12);                                                                                         // 7.1e-16
  EXPECT_LE(measured("materials: modulus against Sacado", difference(library_modulus(), modulus)), 1e-12);  // 5.2e-16
}

TEST_P(AutomaticDerivative, ForceStateByComplexStep) {
  const Vector force = force_state(problem_, extension_);
  EXPECT_LE(measured("materials: t against the second implementation",
                     relative_difference(point_.evaluate(extension_).force_state, force)),
            1e-12);  // 3.6e-16
  std::vector<Vector> modulus(bonds, Vector(bonds));
  const double step = 1e-30;  // no difference is taken: any step whose square vanishes beside 1
  for (int j = 0; j < bonds; ++j) {
    std::vector<Complex> extension(extension_.begin(), extension_.end());
    extension[j] += Complex(0, step);
    const std::vector<Complex> moved = force_state(problem_, extension);
    for (int i = 0; i < bonds; ++i) modulus[i][j] = moved[i].imag() / step;
  }
  EXPECT_LE(measured("materials: modulus against complex step", difference(library_modulus(), modulus)),
            1e-12);  // 3.4e-16
}

std::vector<MaterialRow> rows_of_the_second_implementation() {
  std::vector<MaterialRow> rows;
  for (const MaterialRow& row : material_table())
    for (const char* name : {"elastic", "elastic_plane_strain", "plastic_perfect", "plastic_hardening",
                             "plastic_continuum_hardening", "plastic_combined", "plastic_continuum_combined"})
      if (row.name == name) rows.push_back(row);
  return rows;
}

INSTANTIATE_TEST_SUITE_P(Materials, AutomaticDerivative,
                         ::testing::Combine(::testing::ValuesIn(rows_of_the_second_implementation()),
                                            ::testing::ValuesIn(load_paths())),
                         [](const auto& one) {
                           return std::get<0>(one.param).name + "_" + std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace perinox::test
