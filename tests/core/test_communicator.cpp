#include <gtest/gtest.h>

#include "perinox/core/communicator.hpp"
#include "perinox/core/error.hpp"

namespace perinox::test {
namespace {

TEST(Communicator, AloneEverySumIsItsOwnTerm) {
  const Communicator self(MPI_COMM_SELF);
  EXPECT_EQ(self.size(), 1);
  EXPECT_TRUE(self.is_root());
  EXPECT_EQ(self.sum(2.5), 2.5);
  EXPECT_EQ(self.exclusive_scan(7LL), 0);
  EXPECT_EQ(self.gather(3LL), std::vector<long long>{3});
}

TEST(Communicator, AnInputErrorIsThrownWithItsSentenceAndSilenceIsNot) {
  const Communicator self(MPI_COMM_SELF);
  EXPECT_NO_THROW(self.agree_on_input_error(""));
  try {
    self.agree_on_input_error("deck.yaml:3:1: wrong");
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "deck.yaml:3:1: wrong");
  }
}

}  // namespace
}  // namespace perinox::test
