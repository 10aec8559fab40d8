#include <gtest/gtest.h>

#include <stdexcept>

#include "output/row_order.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {

TEST(RowOrder, ThereAndBackIsTheSame) {
  const body::Body body = test::shuffled_body(Communicator(MPI_COMM_SELF), 50, 3);
  const RowOrder order(body.communicator, body.id, body.owned, body.total);
  EXPECT_EQ(order.first_row(), 0);
  EXPECT_EQ(order.rows(), 50);
  const std::vector<double> values = test::field_values(body, 1, 3);
  EXPECT_EQ(order.to_owners(order.to_rows(values.data(), 3).data(), 3), values);
}

TEST(RowOrder, RefusesIdsThatAreNotAPermutation) {
  const Communicator one(MPI_COMM_SELF);
  EXPECT_THROW(RowOrder(one, {0, 2}, 2, 2), std::logic_error);
  EXPECT_THROW(RowOrder(one, {0, -1}, 2, 2), std::logic_error);
  EXPECT_THROW(RowOrder(one, {1, 1}, 2, 2), std::logic_error);
  EXPECT_THROW(RowOrder(one, {0, 1}, 2, 3), std::logic_error);
}

}  // namespace
}  // namespace perinox::output
