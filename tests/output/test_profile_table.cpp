#include <gtest/gtest.h>

#include "perinox/output/profile_table.hpp"

namespace perinox::output {
namespace {

ProfileReading reading() {
  ProfileReading made;
  const auto set = [&](Section section, long long count, double seconds) {
    made.count[static_cast<std::size_t>(section)] = count;
    made.seconds[static_cast<std::size_t>(section)] = seconds;
  };
  set(Section::product, 3415, 6.25);
  set(Section::preconditioner, 3480, 0.5);
  set(Section::force, 60, 12.5);
  set(Section::output, 21, 0.0625);
  made.wall = 25;
  return made;
}

TEST(ProfileTable, HasTheLongestFirstAndLeavesOutWhatWasNeverEntered) {
  EXPECT_EQ(profile_table(reading()), R"(time of the run      seconds    share      count
  force               12.500   50.0 %         60
  product              6.250   25.0 %       3415
  preconditioner       0.500    2.0 %       3480
  output               0.062    0.2 %         21
  rest                 5.688   22.8 %
  total               25.000
)");
}

TEST(ProfileTable, ARunThatDidNothingHasNoShares) {
  EXPECT_EQ(profile_table(ProfileReading()), R"(time of the run      seconds    share      count
  rest                 0.000    0.0 %
  total                0.000
)");
}

}  // namespace
}  // namespace perinox::output
