#include <gtest/gtest.h>

#include <numeric>
#include <thread>

#include "perinox/core/communicator.hpp"
#include "perinox/core/profile.hpp"

namespace perinox::test {
namespace {

void pass(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

double sum(const ProfileReading& reading) {
  return std::accumulate(reading.seconds.begin(), reading.seconds.end(), 0.0);
}

TEST(Profile, TimeBelongsToTheInnermostSectionAlone) {
  Profile profile;
  {
    const Profile::Scope product(profile, Section::product);
    pass(20);
    {
      const Profile::Scope halo(profile, Section::halo);
      pass(60);
    }
    pass(20);
  }
  pass(30);
  const ProfileReading reading = profile.read();
  EXPECT_EQ(reading.count_of(Section::product), 1);
  EXPECT_EQ(reading.count_of(Section::halo), 1);
  EXPECT_GE(reading.seconds_of(Section::product), 0.040);
  EXPECT_GE(reading.seconds_of(Section::halo), 0.060);
  // No time is counted twice, however late the machine wakes up.
  EXPECT_LE(sum(reading), reading.wall - 0.030 + 1e-9);
  EXPECT_NEAR(reading.rest(), reading.wall - sum(reading), 1e-12);
}

TEST(Profile, ASectionInsideItselfIsCountedTwiceAndTimedOnce) {
  Profile profile;
  {
    const Profile::Scope outer(profile, Section::force);
    pass(10);
    const Profile::Scope inner(profile, Section::force);
    pass(10);
  }
  const ProfileReading reading = profile.read();
  EXPECT_EQ(reading.count_of(Section::force), 2);
  EXPECT_GE(reading.seconds_of(Section::force), 0.020);
  EXPECT_LE(sum(reading), reading.wall);
}

TEST(Profile, AReadingHoldsOpenSectionsAndADifferenceOnlyWhatLiesBetween) {
  Profile profile;
  {
    const Profile::Scope before(profile, Section::output);
    pass(20);
  }
  const ProfileReading first = profile.read();
  const Profile::Scope open(profile, Section::assembly);
  pass(10);
  const ProfileReading between = profile.read() - first;
  EXPECT_EQ(between.count_of(Section::output), 0);
  EXPECT_EQ(between.seconds_of(Section::output), 0);
  EXPECT_EQ(between.count_of(Section::assembly), 1);
  EXPECT_GE(between.seconds_of(Section::assembly), 0.010);
  EXPECT_GE(between.wall, 0.010);
}

TEST(Profile, ASectionIsClosedWhenAnExceptionPasses) {
  Profile profile;
  try {
    const Profile::Scope scope(profile, Section::product);
    throw 1;
  } catch (int) {
  }
  const double before = profile.read().seconds_of(Section::product);
  pass(5);
  EXPECT_EQ(profile.read().seconds_of(Section::product), before);
}

TEST(Profile, EverySectionHasAName) {
  for (std::size_t s = 0; s < section_count; ++s) EXPECT_GT(std::string(name_of(static_cast<Section>(s))).size(), 3u);
}

TEST(Profile, CopiesOfACommunicatorShareItAndOtherCommunicatorsHaveTheirOwn) {
  const Communicator one(MPI_COMM_SELF), other(MPI_COMM_SELF);
  const Communicator copy = one;
  { const Profile::Scope scope(copy.profile(), Section::halo); }
  EXPECT_EQ(one.profile().read().count_of(Section::halo), 1);
  EXPECT_EQ(other.profile().read().count_of(Section::halo), 0);
  const ProfileReading reading = one.profile().read(), slowest = one.slowest(reading);
  EXPECT_EQ(slowest.seconds, reading.seconds);  // one rank
  EXPECT_EQ(slowest.wall, reading.wall);
}

}  // namespace
}  // namespace perinox::test
