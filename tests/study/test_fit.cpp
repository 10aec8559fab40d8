/// Tests slopes, Pareto fronts, orders, ticks, and values between scattered points.
#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "study/fit.hpp"
#include "study/nearby_fit.hpp"
#include "study/scale.hpp"
#include "support/measured.hpp"

namespace perinox::study {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Slope, IsThePowerOfAPowerLaw) {
  std::vector<Pair> pairs;
  for (const double h : {1.0, 0.5, 0.25}) pairs.push_back({h, 3e-4 * std::pow(h, 2.5)});
  EXPECT_NEAR(log_slope(pairs).value(), 2.5, 1e-13);  // 0
  pairs.push_back({0, 1});
  pairs.push_back({2, -1});
  pairs.push_back({3, std::nan("")});
  EXPECT_NEAR(log_slope(pairs).value(), 2.5, 1e-13) << "what has no logarithm is left out";
}

TEST(Slope, IsThatOfLeastSquares) {
  // The logarithms are 0, 1, 2 and 0, 1, 4, so the slope is (2*4)/2 / 2 = 2.
  EXPECT_NEAR(log_slope({{1, 1}, {std::exp(1.0), std::exp(1.0)}, {std::exp(2.0), std::exp(4.0)}}).value(), 2, 1e-13);
}

TEST(Slope, NeedsTwoPlaces) {
  EXPECT_FALSE(log_slope({}));
  EXPECT_FALSE(log_slope({{1, 2}}));
  EXPECT_FALSE(log_slope({{1, 2}, {1, 3}}));
}

TEST(ParetoFront, HoldsWhatNoOtherBeats) {
  EXPECT_THAT(pareto_front({{3, 1}, {1, 3}, {2, 2}, {3, 2}, {2, 4}}), ElementsAre(1, 2, 0));
  EXPECT_THAT(pareto_front({{1, 1}, {1, 1}, {1, 2}}), ElementsAre(0, 1)) << "equals do not beat each other";
  EXPECT_THAT(pareto_front({}), IsEmpty());
}

TEST(NewtonOrder, OfQuadraticAndLinearConvergence) {
  EXPECT_NEAR(newton_order({1e-1, 1e-2, 1e-4, 1e-8}).value(), 2, 1e-12);
  EXPECT_NEAR(newton_order({1e-1, 1e-2, 1e-3, 1e-4}).value(), 1, 1e-12);
  EXPECT_NEAR(newton_order({1e-1, 1e-2, 1e-4, 1e-8, 3e-15}).value(), 2, 1e-12) << "rounding is left out";
  EXPECT_FALSE(newton_order({1, 1e-3}));
  EXPECT_FALSE(newton_order({1e-3, 1e-2, 1e-3}));
}

TEST(NearbyFit, IsExactForQuadraticFields) {
  for (const int dimension : {2, 3}) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> place(0, 1);
    const auto field = [&](const double* x) {
      return 1 + 2 * x[0] - x[1] + 3 * x[0] * x[1] - x[1] * x[1] + (dimension == 3 ? x[2] * x[0] - 2 * x[2] * x[2] : 0);
    };
    std::vector<double> positions, values;
    for (int i = 0; i < 400; ++i) {
      double x[3] = {place(generator), place(generator), dimension == 3 ? place(generator) : 0};
      positions.insert(positions.end(), x, x + 3);
      values.push_back(field(x));
      values.push_back(-x[0]);
    }
    const NearbyFit fit(positions, values, 2, dimension);
    double worst = 0;
    for (int i = 0; i < 50; ++i) {
      const double x[3] = {place(generator), place(generator), dimension == 3 ? place(generator) : 0};
      const std::vector<double> found = fit.at(x);
      ASSERT_EQ(found.size(), 2);
      worst = std::max({worst, std::abs(found[0] - field(x)), std::abs(found[1] + x[0])});
    }
    EXPECT_LE(
        test::measured(dimension == 2 ? "nearby fit, quadratic field, 2-D" : "nearby fit, quadratic field, 3-D", worst),
        1e-13);  // 2.2e-15
  }
}

TEST(NearbyFit, FewPointsGiveWhatTheyHave) {
  const NearbyFit one({0, 0, 0}, {7}, 1, 3);
  const double there[3] = {0, 0, 0};
  EXPECT_NEAR(one.at(there)[0], 7, 1e-12);
}

std::vector<std::string> labels(const Scale& scale) {
  std::vector<std::string> all;
  for (const Tick& tick : scale.ticks())
    if (!tick.label.empty()) all.push_back(tick.label);
  return all;
}

TEST(Scale, LabelsRoundNumbers) {
  EXPECT_THAT(labels(Scale(0, 24, false)), ElementsAre("0", "5", "10", "15", "20", "25"));
  EXPECT_THAT(labels(Scale(1.2e-5, 2e-3, true)),
              ElementsAre("1e-5", "2e-5", "5e-5", "1e-4", "2e-4", "5e-4", "0.001", "0.002"));
  EXPECT_THAT(labels(Scale(1e-14, 1e-2, true)), ElementsAre("1e-14", "1e-12", "1e-10", "1e-8", "1e-6", "1e-4", "0.01"));
  const Scale decades(0.01, 10, true);
  EXPECT_NEAR(decades.position(std::sqrt(0.1)), 0.5, 1e-12);
  EXPECT_THAT(labels(decades), ElementsAre("0.01", "0.1", "1", "10"));
  EXPECT_GT(decades.ticks().size(), 25) << "minor ticks";
}

TEST(Scale, OfOneValueCanBeDrawn) {
  for (const bool logarithmic : {false, true})
    for (const double value : {3.0, 1e-7}) EXPECT_NEAR(Scale(value, value, logarithmic).position(value), 0.5, 1e-9);
  EXPECT_NEAR(Scale(0, 0, false).position(0), 0.5, 1e-9);
}

}  // namespace
}  // namespace perinox::study
