#include <cmath>

#include "deck/fixture.hpp"
#include "perinox/deck/expression.hpp"

namespace perinox::deck {
namespace {

const Location where{"deck.yaml", 3, 9};

double value(const std::string& formula, double x = 0, double y = 0, double z = 0, double t = 0) {
  return Expression(formula, where)(x, y, z, t);
}

std::string refusal(const std::string& formula) {
  try {
    Expression(formula, where);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Expression, ConstantsNeedNoFormula) {
  EXPECT_EQ(Expression()(1, 2, 3, 4), 0.0);
  EXPECT_EQ(Expression(2.5)(1, 2, 3, 4), 2.5);
  EXPECT_EQ(Expression("-1.25e3", where)(1, 2, 3, 4), -1250.0);
  EXPECT_EQ(Expression(0.1).text(), "0.1");
  EXPECT_FALSE(Expression(0.1).uses_time());
}

TEST(Expression, VariablesFunctionsAndConstants) {
  EXPECT_DOUBLE_EQ(value("x + 10*y + 100*z + 1000*t", 1, 2, 3, 4), 4321.0);
  EXPECT_DOUBLE_EQ(value("sin(pi/6)"), 0.5);
  EXPECT_DOUBLE_EQ(value("x^2", 3), 9.0);
  EXPECT_DOUBLE_EQ(value("sqrt(x) + exp(0) + abs(-2) + min(1, 2) + max(1, 2)", 16), 4 + 1 + 2 + 1 + 2);
  EXPECT_DOUBLE_EQ(value("log(exp(2)) + log10(1000)"), 5.0);
  EXPECT_DOUBLE_EQ(value("1e-3*x + 2.E2 + .5", 1), 0.001 + 200 + 0.5);
}

TEST(Expression, ComparisonsAndTernary) {
  EXPECT_EQ(value("z < 1.5 && x >= 2", 2, 0, 1), 1.0);
  EXPECT_EQ(value("z < 1.5 && x >= 2", 1, 0, 1), 0.0);
  EXPECT_EQ(value("z < 1.5 || x == 2", 2, 0, 9), 1.0);
  EXPECT_EQ(value("x > 1 ? 7 : 8", 2), 7.0);
  EXPECT_EQ(value("x > 1 ? 7 : 8", 0), 8.0);
  const Expression ring("(x*x + y*y < 4) && (x*x + y*y > 1)", where);
  EXPECT_TRUE(ring.holds(1.5, 0, 0));
  EXPECT_FALSE(ring.holds(0.5, 0, 0));
  EXPECT_FALSE(ring.holds(2.5, 0, 0));
}

TEST(Expression, KnowsWhetherItUsesTime) {
  EXPECT_TRUE(Expression("0.3*t", where).uses_time());
  EXPECT_FALSE(Expression("0.3*tan(x)", where).uses_time());
  EXPECT_FALSE(Expression("atan2(y, x)", where).uses_time());
}

TEST(Expression, PoleAtTheOriginIsNoMistake) {
  EXPECT_DOUBLE_EQ(value("1/x", 4), 0.25);
  EXPECT_DOUBLE_EQ(value("log(x)", 1), 0.0);
}

TEST(Expression, CopiesGiveTheSameValues) {
  const Expression original("x*t", where);
  const Expression copy = original;
  EXPECT_EQ(original(2, 0, 0, 3), 6.0);
  EXPECT_EQ(copy(5, 0, 0, 7), 35.0);
  EXPECT_EQ(original(2, 0, 0, 3), 6.0);
  EXPECT_EQ(copy.text(), "x*t");
}

TEST(Expression, NamesTheNearestNameOfAnUnknownOne) {
  EXPECT_EQ(
      refusal("2*sine(x)"),
      "deck.yaml:3:9: the formula '2*sine(x)' cannot be read at character 3: sine is not known; did you mean sin?");
  EXPECT_THAT(refusal("xx*2"), ::testing::HasSubstr("xx is not known; did you mean x?"));
  EXPECT_THAT(refusal("sqr(x)"), ::testing::HasSubstr("did you mean sqrt?"));
  EXPECT_THAT(refusal("temperature"), ::testing::HasSubstr("a formula may use x, y, z, t, pi"));
}

TEST(Expression, RefusesWhatTheParserWouldReadOtherwise) {
  EXPECT_THAT(refusal("x and y"), ::testing::HasSubstr("write &&"));
  EXPECT_THAT(refusal("x or y"), ::testing::HasSubstr("write ||"));
  EXPECT_THAT(refusal("not x"), ::testing::HasSubstr("write (...) == 0"));
  EXPECT_THAT(refusal("!x"), ::testing::HasSubstr("write (...) == 0"));
  EXPECT_THAT(refusal("x = 1"), ::testing::HasSubstr("write == to compare"));
  EXPECT_THAT(refusal("x & y"), ::testing::HasSubstr("write && instead of &"));
  EXPECT_THAT(refusal("x**2"), ::testing::HasSubstr("write ^ for a power"));
  EXPECT_THAT(refusal("0 < x < 1"), ::testing::HasSubstr("comparisons cannot be chained"));
  EXPECT_THAT(refusal("x, y"), ::testing::HasSubstr("a comma may only separate a function's arguments"));
  EXPECT_EQ(refusal("0 < x && x < 1"), "");
  EXPECT_EQ(refusal("(x < 1) == (y < 1)"), "");
  EXPECT_EQ(refusal("max(x < 1, y < 1)"), "");
}

TEST(Expression, RefusesBrokenSyntax) {
  for (const char* formula : {"x+", "sin(x", "5)", "1 2", "x y", "sin(x, y)", "()", "2x", "x ? 1", "*x", "\"x\"", "  ",
                              "x..2", "sin", "@", "1e", "0x10"}) {
    EXPECT_THAT(refusal(formula), ::testing::StartsWith("deck.yaml:3:9: ")) << formula;
  }
  EXPECT_THAT(refusal(std::string(20000, ' ') + "x"), ::testing::HasSubstr("at most 10000"));
}

}  // namespace
}  // namespace perinox::deck
