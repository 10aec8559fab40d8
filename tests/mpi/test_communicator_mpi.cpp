#include <gtest/gtest.h>

#include "perinox/core/communicator.hpp"
#include "perinox/core/error.hpp"

namespace perinox::test {
namespace {

TEST(CommunicatorOnRanks, SumsScansAndGathers) {
  const Communicator world(MPI_COMM_WORLD);
  const long long mine = 10 + world.rank(), n = world.size();
  EXPECT_EQ(world.sum(mine), 10 * n + n * (n - 1) / 2);
  EXPECT_EQ(world.max(mine), 10 + n - 1);
  EXPECT_EQ(world.min(static_cast<double>(mine)), 10.0);
  EXPECT_EQ(world.exclusive_scan(mine), 10LL * world.rank() + world.rank() * (world.rank() - 1LL) / 2);
  EXPECT_EQ(world.gather(mine).back(), 10 + n - 1);
  EXPECT_TRUE(world.any(world.rank() == world.size() - 1));
  EXPECT_FALSE(world.any(false));
}

TEST(CommunicatorOnRanks, OneRanksErrorIsEveryRanksError) {
  const Communicator world(MPI_COMM_WORLD);
  const std::string mine = world.rank() == world.size() - 1 ? "the last rank's sentence" : "";
  try {
    world.agree_on_input_error(mine);
    FAIL() << "rank " << world.rank() << " went on";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "the last rank's sentence");
  }
}

}  // namespace
}  // namespace perinox::test
