/// Mitchell's Eq. 65 as it is printed is not the linearisation of his Eq. 45 (docs/theory.md, section 7). Shown here on 8^3
/// particles, all flowing: the consistent form is the derivative, the printed one is not, error by error.
///  (a) The first coefficient, 3k/m - alpha beta/(3N), lacks the factor 3/m of the dilatation's gradient. m is a length
///  to
///      the fifth power, so how wrong it is depends on the unit of length.
///  (b) The third term has a Delta(zeta - xi) that does not belong there: read as one quadrature weight, it leaves only
///      the diagonal of a rank-one state.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

/// The elastic-plastic material with only one of the two errors in its modulus state.
class OneError : public materials::Material {
 public:
  enum class Which { first_coefficient, third_term };
  OneError(const materials::ElasticPlastic::Parameters& right, Which which) : right_(right), which_(which) {}

  materials::HistoryLayout history() const override { return right_.history(); }
  materials::PointState state(const materials::FamilySums& sums, const double* committed,
                              double* trial) const override {
    return right_.state(sums, committed, trial);
  }
  materials::PointModulus modulus(const materials::FamilySums& sums, const double* committed,
                                  deck::TangentForm form) const override {
    return right_.modulus(sums, committed, form);
  }
  void modulus(const materials::Family& family, const double* extension, materials::CommittedHistory committed,
               deck::TangentForm, materials::ModulusState& modulus) const override {
    materials::ModulusState right;
    right_.modulus(family, extension, committed, deck::TangentForm::consistent, right);
    ASSERT_EQ(right.rank(), 2);  // flows
    modulus.reset(family.count);
    std::copy(right.diagonal(), right.diagonal() + family.count, modulus.diagonal());
    const bool first = which_ == Which::first_coefficient;
    // 3k/m - alpha beta/(3N) is m/3 times the right coefficient (9k - m alpha beta/N)/m^2.
    modulus.add_radial(right.term(0).coefficient * (first ? family.weighted_volume / 3 : 1.0));
    const auto& term = right.term(1);
    if (first) {
      std::copy(term.p, term.p + family.count, modulus.add_symmetric(term.coefficient));
    } else {
      for (int j = 0; j < family.count; ++j)
        modulus.diagonal()[j] += term.coefficient * term.p[j] * term.p[j] * family.weight[j];
    }
  }
  materials::ElasticModuli elastic_moduli(int dimension) const override { return right_.elastic_moduli(dimension); }
  std::string summary() const override { return right_.summary(); }

 private:
  materials::ElasticPlastic right_;
  Which which_;
};

const materials::ElasticPlastic::Parameters parameters{bulk, shear, yield_shear, 0, false, true};

/// The state in which every test below looks at the tangent: all 512 points flow.
class EquationSixtyFive {
 public:
  EquationSixtyFive(double spacing, std::unique_ptr<materials::Material> material)
      : scene_(make_scene(lattice_deck(deck::Dimension::three, {8, 8, 8}, spacing, 3.015),
                          materials_of(std::move(material)))),
        start_(scene_),
        field_(field_of(scene_, {4.0})),
        tangent_(scene_) {
    EXPECT_EQ(internal_force(scene_, start_, field_).trial.yielding, 512);
  }
  /// Relative error along a random direction, in which neighbours move apart and together at random.
  double random_error(deck::TangentForm form) { return error(form, random_field(scene_, 1, 23)); }
  /// The same along a smooth one: a uniform deformation of every component.
  double smooth_error(deck::TangentForm form) {
    Vector direction = affine_field(scene_, {{{1.1, 0.3, 0.2}, {0.1, 0.7, 0.4}, {-0.2, 0.3, 0.9}}});
    const double largest = largest_magnitude(direction);
    for (double& value : direction) value /= largest;
    return error(form, direction);
  }

 private:
  double error(deck::TangentForm form, const Vector& direction) {
    tangent_.linearise(start_, field_.data(), form);
    return tangent_error(scene_, start_, field_, direction, tangent_);
  }
  mechanics::Scene scene_;
  mechanics::Committed start_;
  Vector field_;
  mechanics::StoredTangent tangent_;
};

EquationSixtyFive whole_material(double spacing) {
  return {spacing, std::make_unique<materials::ElasticPlastic>(parameters)};
}
EquationSixtyFive with_one_error(double spacing, OneError::Which which) {
  return {spacing, std::make_unique<OneError>(parameters, which)};
}
constexpr auto consistent = deck::TangentForm::consistent;
constexpr auto printed = deck::TangentForm::printed;

TEST(PrintedTangent, ConsistentFormIsTheDerivativeInEveryUnitOfLength) {
  for (double spacing : {2.0, 1.0, 0.5, 0.125, 1e-3}) {
    EquationSixtyFive state = whole_material(spacing);
    EXPECT_LE(measured("Eq. 65: consistent form, random direction", state.random_error(consistent)), 1e-8);  // 3.0e-11
    EXPECT_LE(measured("Eq. 65: consistent form, smooth direction", state.smooth_error(consistent)), 1e-8);  // 2e-11
  }
}

TEST(PrintedTangent, PrintedFormIsWrongByAnAmountThatDependsOnTheUnitOfLength) {
  // The same body, strain and direction in units in which its spacing is 1, 0.62, 0.5, 1/8 and 1e-3. Own measurements.
  struct Row {
    double spacing, random, smooth;
  };
  const Row rows[] = {
      {1, 78.3, 112}, {0.62, 6.46, 9.50}, {0.5, 1.69, 2.68}, {0.125, 0.825, 0.939}, {1e-3, 0.827, 0.942}};
  for (const Row& row : rows) {
    SCOPED_TRACE(row.spacing);
    EquationSixtyFive state = whole_material(row.spacing);
    const std::string name = fmt::format("Eq. 65, h = {:5}: printed form, ", row.spacing);
    EXPECT_NEAR(measured(name + "random direction", state.random_error(printed)) / row.random, 1, 0.01);
    EXPECT_NEAR(measured(name + "smooth direction", state.smooth_error(printed)) / row.smooth, 1, 0.01);
  }
}

TEST(PrintedTangent, FirstCoefficientIsOffByAThirdOfTheWeightedVolume) {
  // With a spacing of 0.5 m/3 is about 7 inside: the lattice's 1.131 (docs/theory.md, section 11) of 4 pi delta^5/5.
  const mechanics::Scene inside = make_scene(lattice_deck(deck::Dimension::three, {8, 8, 8}, 0.5, 3.015),
                                             materials_of(std::make_unique<materials::ElasticPlastic>(parameters)));
  const Vector& m = inside.bonds().weighted_volume;
  EXPECT_NEAR(measured("Eq. 65: m/3 inside, h = 0.5", *std::max_element(m.begin(), m.end()) / 3), 7.38, 0.01);

  // m grows as the fifth power of the unit, and with it the error, once m/3 is much larger than 1.
  constexpr auto which = OneError::Which::first_coefficient;
  const double at_one = with_one_error(1, which).random_error(consistent);
  const double at_two = with_one_error(2, which).random_error(consistent);
  // 32 (a - 1/32)/(a - 1) for a = m/3 of about 95, the mean over the body: 32.3.
  EXPECT_NEAR(measured("Eq. 65: first coefficient's error at h = 2 over that at h = 1", at_two / at_one), 32.3, 0.2);
  // In small units the coefficient all but vanishes: what is left out is the whole volumetric part.
  EXPECT_NEAR(
      measured("Eq. 65: first coefficient alone wrong, h = 1e-3", with_one_error(1e-3, which).random_error(consistent)),
      0.827, 0.005);
}

TEST(PrintedTangent, ThirdTermAloneIsOffInEveryUnit) {
  for (double spacing : {1.0, 0.5, 1e-3}) {
    EquationSixtyFive state = with_one_error(spacing, OneError::Which::third_term);
    EXPECT_NEAR(measured("Eq. 65: third term alone wrong, random direction", state.random_error(consistent)), 0.0230,
                2e-4);
    EXPECT_NEAR(measured("Eq. 65: third term alone wrong, smooth direction", state.smooth_error(consistent)), 0.0702,
                5e-4);
  }
}

}  // namespace
}  // namespace perinox::test
