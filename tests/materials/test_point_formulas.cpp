/// For every material in every state and with every influence function, the force state is the derivative of an energy,
/// the modulus state is the derivative of the force state, and plastic flow obeys its yield surface (docs/theory.md,
/// sections 2, 3 and 5).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "support/material_table.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

constexpr int bonds = 24;

class PointFormulas : public ::testing::TestWithParam<std::tuple<MaterialRow, LoadPath, deck::Influence>> {
 protected:
  const MaterialRow& row() const { return std::get<0>(GetParam()); }
  const LoadPath& path() const { return std::get<1>(GetParam()); }

  PointFormulas()
      : material_(row().make()),
        family_(random_family(row().dimension, std::get<2>(GetParam()), bonds, 7)),
        point_(*material_, family_) {
    const auto& stops = path().stops;
    for (std::size_t s = 0; s < stops.size(); ++s) {
      // The dilatation changes from stop to stop and must not matter to the flow. (Where dilatation is off it does
      // matter, so it is kept too small to make the elastic stops flow.)
      extension_ = random_extension(family_, stops[s].shear * yield_strain,
                                    (0.3 - 0.2 * static_cast<double>(s)) * yield_strain, stops[s].direction);
      if (s + 1 < stops.size()) point_.commit(point_.evaluate(extension_));
    }
  }

  /// Derivative of `value` along `direction` at the extension under test, by central differences of fourth order with
  /// the given step. They are exact for polynomials up to the fourth degree.
  template <class Value>
  auto derivative(const Vector& direction, double step, Value value) const {
    const auto at = [&](double s) {
      Vector moved = extension_;
      for (std::size_t j = 0; j < moved.size(); ++j) moved[j] += s * step * direction[j];
      return value(point_.evaluate(moved));
    };
    return combine(at(1), at(-1), at(2), at(-2), step);
  }
  static double combine(double a, double b, double c, double d, double step) {
    return (8 * (a - b) - (c - d)) / (12 * step);
  }
  static Vector combine(const Vector& a, const Vector& b, const Vector& c, const Vector& d, double step) {
    Vector result(a.size());
    for (std::size_t j = 0; j < a.size(); ++j) result[j] = combine(a[j], b[j], c[j], d[j], step);
    return result;
  }

  std::unique_ptr<materials::Material> material_;
  RandomFamily family_;
  MaterialPoint point_;
  Vector extension_;
};

// Steps of the difference quotients, relative to the yield extension of a bond of unit length. They are small beside
// the distance of every state to the yield surface (at least 0.1 yield strains) and large beside rounding.
const double steps[] = {1e-1, 3e-2, 1e-2, 3e-3, 1e-3};

TEST_P(PointFormulas, FlowsWhereThePathSaysSo) {
  const Evaluation now = point_.evaluate(extension_);
  EXPECT_EQ(now.response.yielding, path().yields && !row().surface.empty());
  for (const Vector* written : {&now.force_state, &now.point_history, &now.bond_history})
    for (double value : *written) EXPECT_TRUE(std::isfinite(value));
}

TEST_P(PointFormulas, ForceStateIsTheDerivativeOfThePotential) {
  const Vector force_state = point_.evaluate(extension_).force_state;
  double best = 1;
  for (double step : steps) {
    Vector quotient(bonds);
    for (int j = 0; j < bonds; ++j) {
      Vector unit(bonds, 0.0);
      unit[j] = 1;
      quotient[j] =
          derivative(unit, step * yield_strain, [](const Evaluation& e) { return e.potential(); }) / family_.weight[j];
    }
    best = std::min(best, relative_difference(quotient, force_state));
  }
  EXPECT_LE(measured("materials: t against dW/de", best), 1e-10);  // 3.0e-12
}

TEST_P(PointFormulas, ModulusStateIsTheDerivativeOfTheForceState) {
  const materials::ModulusState modulus = point_.modulus(extension_);
  for (unsigned seed = 20; seed < 24; ++seed) {
    const Vector direction = random_values(bonds, seed);
    const Vector expected = point_.apply(modulus, direction);
    double best = 1;
    for (double step : steps)
      best = std::min(best, relative_difference(derivative(direction, step * yield_strain,
                                                           [](const Evaluation& e) { return e.force_state; }),
                                                expected));
    EXPECT_LE(measured("materials: modulus against dt/de", best), 1e-10);  // 1.9e-12
  }
}

TEST_P(PointFormulas, ModulusStateIsSymmetric) {
  if (!material_->symmetric()) return;  // does not promise it
  const materials::ModulusState modulus = point_.modulus(extension_);
  const Vector x = random_values(bonds, 31), y = random_values(bonds, 32);
  const Vector kx = point_.apply(modulus, x), ky = point_.apply(modulus, y);
  const double scale = std::sqrt(family_.dot(x, x) * family_.dot(ky, ky));
  EXPECT_LE(measured("materials: asymmetry of the modulus", std::abs(family_.dot(x, ky) - family_.dot(y, kx)) / scale),
            1e-14);  // 9.7e-17
}

class PlasticPointFormulas : public PointFormulas {};

TEST_P(PlasticPointFormulas, PlasticExtensionStaysDeviatoric) {
  if (!row().surface[0].volume_preserving || path().name == "elastic") return;  // another flow, or none yet
  const Vector plastic = point_.evaluate(extension_).bond_history;
  const double sum = family_.influence_dot(family_.length, plastic);
  const double scale =
      std::sqrt(family_.influence_dot(family_.length, family_.length) * family_.influence_dot(plastic, plastic));
  ASSERT_GT(scale, 0);
  EXPECT_LE(measured("materials: volume of the plastic extension", std::abs(sum) / scale), 1e-14);  // 1.4e-16
}

TEST_P(PlasticPointFormulas, EndsOnTheYieldSurfaceAndStaysThere) {
  const YieldSurface& surface = row().surface[0];
  if (surface.plane) GTEST_SKIP() << "test_plane_plasticity.cpp has its yield value";
  const double d = row().dimension, m = family_.weighted_volume;
  const Evaluation now = point_.evaluate(extension_);

  // This is the norm of the part that yields, from the force state and the history. A bond without influence carries
  // none.
  double square = 0;
  const double pressure = d * bulk * now.response.dilatation / m;
  // The back stress alpha h e_p, h = H_k/mu, is subtracted. The bonds carry (1 + h) e_p.
  const double overlay = surface.kinematic / shear, back = d * (d + 2) * shear / m * overlay / (1 + overlay);
  const auto yields = [&](int j) {
    return now.force_state[j] - family_.influence[j] * (pressure * family_.length[j] + back * now.bond_history[j]);
  };
  for (int j = 0; j < bonds; ++j)
    if (family_.influence[j] > 0) square += yields(j) * yields(j) / family_.influence[j] * family_.weight[j];
  // beta^2 = 2 psi0 = d(d+2) tau^2/m; the equivalent strain is gamma_p/sqrt(3).
  const double tau = surface.yield_stress(std::sqrt(3.0) * now.point_history.at(1));
  const double beta = tau * std::sqrt(d * (d + 2) / (surface.continuum ? family_.continuum_weighted_volume : m));
  if (!path().yields) {
    EXPECT_LT(std::sqrt(square), beta);
    EXPECT_EQ(now.response.dissipation, 0);
    EXPECT_EQ(now.point_history, point_.committed_point());
    EXPECT_EQ(now.bond_history, point_.committed_bond());
    return;
  }
  EXPECT_LE(measured("materials: distance to the yield surface", std::abs(std::sqrt(square) / beta - 1)),
            1e-14);  // 3.3e-16

  // The dissipation is the yield stress times the flow. t_d . e_p of the step is that at the step's end, which is Delta
  // lambda beta^2.
  const double lambda = now.point_history.at(0) - point_.committed_point().at(0);
  const double flow = std::sqrt(3.0) * (now.point_history.at(1) - point_.committed_point().at(1));
  EXPECT_GT(now.response.dissipation, 0);
  if (!surface.table) {  // test_hardening.cpp has its work
    EXPECT_LE(measured("materials: dissipation against yield stress times flow",
                       std::abs(now.response.dissipation / ((tau - 0.5 * surface.hardening * flow) * flow) - 1)),
              1e-13);
  }
  double work = 0;
  for (int j = 0; j < bonds; ++j)
    work += yields(j) * (now.bond_history[j] - point_.committed_bond()[j]) / (1 + overlay) * family_.weight[j];
  EXPECT_LE(measured("materials: t_d . de_p against lambda beta^2", std::abs(work / (lambda * beta * beta) - 1)),
            1e-14);  // 6.7e-16
  EXPECT_LE(measured("materials: t_d . de_p against yield stress times flow", std::abs(work / (tau * flow) - 1)),
            1e-13);

  // The state that is reached is an elastic one of the next step.
  MaterialPoint next = point_;
  next.commit(now);
  const Evaluation again = next.evaluate(extension_);
  EXPECT_FALSE(again.response.yielding);
  EXPECT_EQ(again.response.dissipation, 0);
  EXPECT_EQ(again.point_history, now.point_history);
  EXPECT_LE(measured("materials: force after commit", relative_difference(again.force_state, now.force_state)),
            2e-14);  // 9.5e-16
}

std::string name_of_case(const ::testing::TestParamInfo<PointFormulas::ParamType>& info) {
  return std::get<0>(info.param).name + "_" + std::get<1>(info.param).name + "_" + name_of(std::get<2>(info.param));
}

const auto influences =
    ::testing::Values(deck::Influence::constant, deck::Influence::inverse, deck::Influence::polynomial);

INSTANTIATE_TEST_SUITE_P(Materials, PointFormulas,
                         ::testing::Combine(::testing::ValuesIn(material_table()), ::testing::ValuesIn(load_paths()),
                                            influences),
                         name_of_case);

std::vector<MaterialRow> rows_with_a_yield_surface() {
  std::vector<MaterialRow> rows;
  for (const MaterialRow& row : material_table())
    if (!row.surface.empty()) rows.push_back(row);
  return rows;
}

INSTANTIATE_TEST_SUITE_P(Materials, PlasticPointFormulas,
                         ::testing::Combine(::testing::ValuesIn(rows_with_a_yield_surface()),
                                            ::testing::ValuesIn(load_paths()), influences),
                         name_of_case);

// A model that nobody has put into the table is not tested. This test then fails.
TEST(MaterialTable, HasEveryRegisteredModel) {
  std::vector<std::string> tested;
  for (const MaterialRow& row : material_table()) tested.push_back(row.model);
  const auto registered = materials::declarations();
  EXPECT_FALSE(registered.empty());
  for (const deck::ModelDeclaration& model : registered) EXPECT_THAT(tested, ::testing::Contains(model.name));
}

}  // namespace
}  // namespace perinox::test
