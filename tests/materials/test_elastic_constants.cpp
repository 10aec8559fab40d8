/// Any two of the five elastic constants give the same material (docs/theory.md, section 2). Too few and contradictory
/// ones are refused in a sentence that names the deck's line.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "materials/elastic_constants.hpp"
#include "perinox/core/error.hpp"
#include "perinox/materials/material.hpp"
#include "support/measured.hpp"

namespace perinox::materials {
namespace {

using Constants = std::vector<std::pair<std::string, double>>;
using ::testing::HasSubstr;

deck::Value scalar(const std::string& text) { return deck::Value::scalar(text, {"plate.yaml", 7, 5}, true); }

deck::Material material_of(const std::string& model, const std::vector<std::pair<std::string, deck::Value>>& entries) {
  const deck::Location where{"plate.yaml", 6, 3};
  return {where, "steel", model, deck::Value::map(entries, where, true)};
}

deck::Material elastic_of(const Constants& constants) {
  std::vector<std::pair<std::string, deck::Value>> entries{{"dilatation", scalar("true")}};
  for (const auto& [key, value] : constants) entries.emplace_back(key, scalar(fmt::format("{:.17g}", value)));
  return material_of("elastic", entries);
}

std::string refusal(const deck::Material& material) {
  try {
    elastic_constants(material);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

/// The five constants of one material, by the textbook formulas from k and mu.
Constants all_five(double k, double mu) {
  return {{"bulk_modulus", k},
          {"shear_modulus", mu},
          {"young_modulus", 9 * k * mu / (3 * k + mu)},
          {"poisson_ratio", (3 * k - 2 * mu) / (6 * k + 2 * mu)},
          {"lame_lambda", k - 2 * mu / 3}};
}

struct Solid {
  const char* name;
  double bulk, shear;
};
// An ordinary solid, a nearly incompressible one (nu = 0.498), and one of negative Poisson's ratio and lambda (nu =
// -0.35).
const Solid solids[] = {{"steel", 160e9, 79e9}, {"rubber", 2e9, 8e6}, {"auxetic", 3e6, 8e6}};

TEST(ElasticConstants, AllTenPairsGiveTheSameMaterial) {
  for (const Solid& solid : solids) {
    const Constants five = all_five(solid.bulk, solid.shear);
    int pairs = 0;
    for (std::size_t a = 0; a < five.size(); ++a)
      for (std::size_t b = a + 1; b < five.size(); ++b, ++pairs) {
        SCOPED_TRACE(fmt::format("{}: {} and {}", solid.name, five[a].first, five[b].first));
        const ElasticConstants found = elastic_constants(elastic_of({five[a], five[b]}));
        // Pairs with Poisson's ratio divide by 1 - 2 nu, which amplifies rounding 250 times for the rubber.
        EXPECT_LE(test::measured("elastic constants: k", std::abs(found.bulk / solid.bulk - 1)), 1e-12);     // 1.4e-14
        EXPECT_LE(test::measured("elastic constants: mu", std::abs(found.shear / solid.shear - 1)), 1e-12);  // 1.5e-14
      }
    EXPECT_EQ(pairs, 10);
    EXPECT_LE(std::abs(elastic_constants(elastic_of(five)).bulk / solid.bulk - 1), 1e-14);
  }
}

TEST(ElasticConstants, DerivedOnesAndTheTwoDimensionalBulkModulus) {
  const ElasticConstants steel{160e9, 79e9};
  const Constants five = all_five(steel.bulk, steel.shear);
  EXPECT_DOUBLE_EQ(steel.young(), five[2].second);
  EXPECT_DOUBLE_EQ(steel.poisson(), five[3].second);
  EXPECT_DOUBLE_EQ(steel.bulk_of(deck::Dimension::three), steel.bulk);
  // Under equal biaxial strain e in the plane, stress over 2 e is lambda + mu in plane strain and E/(2 (1 - nu)) in
  // plane stress.
  EXPECT_NEAR(steel.bulk_of(deck::Dimension::plane_strain) / (five[4].second + steel.shear), 1, 1e-14);
  EXPECT_NEAR(steel.bulk_of(deck::Dimension::plane_stress) / (steel.young() / (2 * (1 - steel.poisson()))), 1, 1e-14);
}

TEST(ElasticConstants, TooFewAreRefused) {
  EXPECT_THAT(refusal(elastic_of({})),
              HasSubstr("plate.yaml:6:3: material steel needs two elastic constants and has 0"));
  EXPECT_THAT(refusal(elastic_of({{"young_modulus", 200e9}})),
              ::testing::AllOf(HasSubstr("plate.yaml:6:3: material steel needs two elastic constants and has 1"),
                               HasSubstr("bulk_modulus, shear_modulus, young_modulus, poisson_ratio, lame_lambda")));
}

TEST(ElasticConstants, ContradictionsAreRefused) {
  const Constants five = all_five(160e9, 79e9);
  // The third of three constants is off by 1e-5, which is more than the 1e-6 allowed, and by 1e-7, which is less.
  for (std::size_t third = 2; third < five.size(); ++third) {
    SCOPED_TRACE(five[third].first);
    Constants three{five[0], five[1], five[third]};
    three[2].second += 1e-5 * (third == 3 ? 1 : third == 4 ? five[0].second : five[third].second);
    EXPECT_THAT(refusal(elastic_of(three)),
                HasSubstr("plate.yaml:6:3: the 3 elastic constants of material steel contradict each other"));
    three[2].second = five[third].second * (1 + 1e-7);
    EXPECT_EQ(refusal(elastic_of(three)), "(accepted)");
  }
}

TEST(ElasticConstants, PairsWithoutAPositiveModulusAreRefused) {
  const std::string sentence = "do not give a positive bulk and shear modulus";
  EXPECT_THAT(refusal(elastic_of({{"shear_modulus", 1}, {"young_modulus", 3.1}})), HasSubstr(sentence));  // nu > 0.5
  EXPECT_THAT(refusal(elastic_of({{"bulk_modulus", 1}, {"lame_lambda", 1}})), HasSubstr(sentence));       // mu = 0
  EXPECT_THAT(refusal(elastic_of({{"poisson_ratio", 0}, {"lame_lambda", 0}})), HasSubstr(sentence));      // undefined
}

TEST(Registry, MakesMaterialsFromTheDeck) {
  const std::unique_ptr<Material> elastic =
      make(elastic_of({{"young_modulus", 200e9}, {"poisson_ratio", 0.3}}), deck::Dimension::plane_stress);
  // kappa of plane stress is E/(2 (1 - nu)).
  EXPECT_THAT(elastic->summary(), HasSubstr(fmt::format("kappa {:g}", 200e9 / 1.4)));
  EXPECT_TRUE(elastic->history().point.empty());
  EXPECT_EQ(elastic->history().per_bond, 0);
}

deck::Material plastic_of(const char* test_kind, double yield, const char* hardening_kind, double hardening) {
  const deck::Location where{"plate.yaml", 9, 5};
  const auto choice = [&](const char* kind, double value) {
    return deck::Value::map({{kind, scalar(fmt::format("{:.17g}", value))}}, where, true);
  };
  return material_of("elastic-plastic", {{"bulk_modulus", scalar("160e9")},
                                         {"shear_modulus", scalar("80e9")},
                                         {"dilatation", scalar("true")},
                                         {"yield_stress", choice(test_kind, yield)},
                                         {"hardening_modulus", choice(hardening_kind, hardening)},
                                         {"kinematic_hardening_modulus", choice(hardening_kind, 2 * hardening)},
                                         {"yield_scaling", scalar("discrete")}});
}

TEST(Registry, TensionAndShearYieldMeanTheSameMaterial) {
  // The conversions are sigma_y = sqrt(3) tau_y (Eq. 56) and d sigma/d eps_p = 3 d tau/d gamma_p.
  const auto tension = make(plastic_of("tension", 300e6, "tension", 6e9), deck::Dimension::three);
  const auto shear = make(plastic_of("shear", 300e6 / std::sqrt(3.0), "shear", 2e9), deck::Dimension::three);
  EXPECT_EQ(tension->summary(), shear->summary());
  EXPECT_THAT(tension->summary(),
              HasSubstr("(3e+08 in tension), hardening 2e+09 in shear, kinematic hardening 4e+09 in shear"));
  EXPECT_EQ(tension->history().per_bond, 1);
}

TEST(Registry, PlasticityInTwoDimensionsKnowsTheStrainOutOfThePlane) {
  for (const deck::Dimension dimension : {deck::Dimension::plane_strain, deck::Dimension::plane_stress})
    EXPECT_THAT(make(plastic_of("shear", 1e8, "shear", 0), dimension)->history().point,
                testing::Contains("plastic_strain_zz"));
}

TEST(Registry, NamesTheNearestModel) {
  try {
    make(material_of("elastik", {}), deck::Dimension::three);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("plate.yaml:6:3: there is no material model elastik; the nearest is elastic"));
  }
}

}  // namespace
}  // namespace perinox::materials
