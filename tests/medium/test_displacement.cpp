/// Numbers of states: what has one number is one state, and whatever may have changed has a new one.
#include <gtest/gtest.h>

#include "perinox/medium/displacement.hpp"

namespace perinox::medium {
namespace {

TEST(Displacement, KeepsItsNumberUntilItMayChange) {
  Displacement u({1, 2});
  const std::uint64_t first = u.at().version;
  EXPECT_EQ(u.at().version, first);
  EXPECT_EQ(u.at().displacement, u.values().data());
  u.change()[0] = 3;
  EXPECT_NE(u.at().version, first);
  EXPECT_EQ(u.values(), (std::vector<double>{3, 2}));
}

TEST(Displacement, CopiesAreTheSameStateUntilOneIsChanged) {
  Displacement u({1, 2}), copy = u;
  EXPECT_EQ(copy.at().version, u.at().version);
  copy.change()[1] = 5;
  EXPECT_NE(copy.at().version, u.at().version);
  EXPECT_EQ(u.values(), (std::vector<double>{1, 2}));
}

TEST(Displacement, WithoutANumberIsAlwaysANewState) {
  const std::vector<double> values{1, 2};
  const At one = values.data(), other = values.data();
  EXPECT_NE(one.version, other.version);
  EXPECT_NE(one.version, 0U);
}

}  // namespace
}  // namespace perinox::medium
