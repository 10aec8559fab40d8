/// Compares the k-d tree with a search over all pairs.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "body/neighbor_count.hpp"
#include "perinox/body/neighbor_search.hpp"

namespace perinox::body {
namespace {

std::vector<std::vector<LocalIndex>> by_all_pairs(const std::vector<double>& points, int dimension, int queries,
                                                  double radius) {
  const int count = static_cast<int>(points.size()) / dimension;
  std::vector<std::vector<LocalIndex>> neighbors(static_cast<std::size_t>(queries));
  for (int i = 0; i < queries; ++i) {
    for (int j = 0; j < count; ++j) {
      double squared = 0;
      for (int c = 0; c < dimension; ++c) squared += std::pow(points[i * dimension + c] - points[j * dimension + c], 2);
      if (i != j && std::sqrt(squared) <= radius * (1 + 1e-10)) neighbors[i].push_back(j);
    }
  }
  return neighbors;
}

std::vector<double> random_points(int count, int dimension) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(-3, 3);
  std::vector<double> points(static_cast<std::size_t>(count * dimension));
  for (double& x : points) x = place(generator);
  return points;
}

TEST(NeighborSearch, FindsWhatAllPairsFind) {
  for (const int dimension : {2, 3}) {
    const std::vector<double> points = random_points(400, dimension);
    for (const double radius : {0.01, 0.5, 1.3, 20.0}) {
      EXPECT_EQ(neighbors_within(points, dimension, 150, radius), by_all_pairs(points, dimension, 150, radius));
    }
  }
}

/// On a lattice whose coordinates are not exact, neighbours at exactly the radius must all be inside.
TEST(NeighborSearch, PointsAtExactlyTheRadiusAreInside) {
  std::vector<double> points;
  for (int z = 0; z < 7; ++z)
    for (int y = 0; y < 7; ++y)
      for (int x = 0; x < 7; ++x) points.insert(points.end(), {1e3 + x * 0.1, 1e3 + y * 0.1, 1e3 + z * 0.1});
  EXPECT_EQ(neighbors_within(points, 3, 343, 0.3)[171].size(), 122U);
  EXPECT_EQ(neighbors_within(points, 3, 343, 0.3 * (1 - 1e-9))[171].size(), 92U);
}

TEST(NeighborCount, CountsWhatTheTreeFinds) {
  for (const int dimension : {2, 3}) {
    std::vector<double> points = random_points(400, dimension);
    for (int c = 0; c < dimension; ++c) points.push_back(90);  // far away: fewer, larger cells
    for (const double radius : {0.01, 0.5, 1.3, 20.0}) {
      const auto found = neighbors_within(points, dimension, 401, radius);
      const std::vector<double> counts = count_within(points, dimension, 401, radius);
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(counts[i], static_cast<double>(found[i].size()));
    }
  }
  EXPECT_TRUE(count_within({}, 3, 0, 1).empty());
}

TEST(NeighborSearch, NothingToFind) {
  EXPECT_TRUE(neighbors_within({}, 3, 0, 1).empty());
  EXPECT_TRUE(neighbors_within({1, 2, 3}, 3, 1, 1).at(0).empty());
  const std::vector<double> none;
  const NeighborSearch search(none, 2);
  const double center[2] = {0, 0};
  double distance = 0;
  EXPECT_EQ(search.nearest(center, distance), -1);
}

TEST(NeighborSearch, NearestLeavesOneOut) {
  const std::vector<double> points = {0, 0, 1, 0, 3, 0};
  const NeighborSearch search(points, 2);
  double distance = 0;
  EXPECT_EQ(search.nearest(&points[2], distance), 1);
  EXPECT_EQ(distance, 0);
  EXPECT_EQ(search.nearest(&points[2], distance, 1), 0);
  EXPECT_EQ(distance, 1);
}

}  // namespace
}  // namespace perinox::body
