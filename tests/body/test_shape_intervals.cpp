/// Tests the parts of straight segments inside shapes.
#include <cmath>
#include <random>

#include "perinox/body/shape.hpp"
#include "perinox/body/shape_intervals.hpp"
#include "support/measured.hpp"
#include "surface_sums.hpp"

namespace perinox::body::fixture {
namespace {

using deck::Point;

/// Largest difference between the ends of the intervals found and expected; 1e300 if their numbers differ.
double off(const Intervals& found, const Intervals& expected) {
  if (found.size() != expected.size()) return 1e300;
  double largest = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
    largest = std::max(
        {largest, std::abs(found[k].first - expected[k].first), std::abs(found[k].second - expected[k].second)});
  return test::measured("intervals: ends", largest);
}

constexpr double bound = 2e-9;  // the slack of 1e-10 of a shape's size over the segment's length; measured 6e-10

TEST(ShapeIntervals, OfEveryShape) {
  const auto in = [](decltype(deck::Shape::form) form, const Point& a, const Point& b, int dimension = 3) {
    return intervals_inside(shape_of(std::move(form)), a, b, dimension);
  };
  EXPECT_LE(off(in(deck::Box{{0, 0, 0}, {4, 2, 2}}, {-1, 1, 1}, {7, 1, 1}), {{0.125, 0.625}}), bound);
  EXPECT_LE(off(in(deck::Sphere{{0, 0, 0}, 5}, {-10, 3, 0}, {10, 3, 0}), {{0.3, 0.7}}), bound);
  EXPECT_LE(off(in(deck::Sphere{{0, 0, 9}, 5}, {-10, 3, 0}, {10, 3, 0}, 2), {{0.3, 0.7}}), bound);
  // A cylinder askew is cut along its own axis and across it.
  const deck::Cylinder askew{{1, 2, 3}, {4, 6, 3}, 2};
  EXPECT_LE(off(in(askew, {-2, -2, 3}, {7, 10, 3}), {{1.0 / 3, 2.0 / 3}}), bound);
  EXPECT_LE(off(in(askew, {2.5, 4, -1}, {2.5, 4, 7}), {{0.25, 0.75}}), bound);
  EXPECT_LE(off(in(deck::Cylinder{{0, 0, 0}, {3, 4, 0}, 1}, {-1.5, -2, 0}, {4.5, 6, 0}, 2), {{0.25, 0.75}}), bound);
  const deck::PlateWithHole plate{{0, 0, 0}, {8, 8, 1}, {4, 4, 0}, 2};
  EXPECT_LE(off(in(plate, {0, 4, 0.5}, {8, 4, 0.5}), {{0, 0.25}, {0.75, 1}}), bound);
  EXPECT_LE(off(in(plate, {0, 4, 0}, {8, 4, 0}, 2), {{0, 0.25}, {0.75, 1}}), bound);
  EXPECT_TRUE(in(plate, {4, 4, -1}, {4, 4, 2}).empty());
  // The next shapes are a slit of 0.2 through a plate, and two boxes that touch.
  const auto slit = difference({box({0, 0, 0}, {10, 10, 0}), box({4, 4.9, 0}, {11, 5.1, 0})});
  EXPECT_LE(off(in(slit, {6, 4, 0}, {6, 6, 0}, 2), {{0, 0.45}, {0.55, 1}}), bound);
  EXPECT_LE(off(in(slit, {2, 4, 0}, {2, 6, 0}, 2), {{0, 1}}), 0);
  EXPECT_LE(off(in(union_of({box({0, 0, 0}, {0.1 + 0.2, 1, 1}), box({0.3, 0, 0}, {1, 1, 1})}), {0.1, 0.5, 0.5},
                   {0.9, 0.5, 0.5}),
                {{0, 1}}),
            0);
}

TEST(ShapeIntervals, TouchingIsInside) {
  const auto box3 = box({0, 0, 0}, {1, 1, 1});
  EXPECT_LE(off(intervals_inside(box3, {0, 0, 1}, {1, 1, 1}, 3), {{0, 1}}), 0);       // along a face
  EXPECT_EQ(intervals_inside(box3, {0.5, 1.5, 0.5}, {1.5, 0.5, 0.5}, 3).size(), 1U);  // an edge
  EXPECT_TRUE(intervals_inside(box3, {0.5, 1.5001, 0.5}, {1.5, 0.5001, 0.5}, 3).empty());
  const auto cut = shape_of(difference({box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 4})}));
  EXPECT_LE(off(intervals_inside(cut, {0, 1, 2}, {3, 1, 2}, 3), {{0, 1}}), 0);                // along the notch
  EXPECT_LE(off(intervals_inside(cut, {0, 0, 2}, {2, 2, 2}, 3), {{0, 0.5}, {1, 1}}), bound);  // ends on its far edge
  EXPECT_LE(off(intervals_inside(cut, {0, 2, 2}, {2, 0, 2}, 3), {{0, 1}}), bound);            // through its near edge
}

/// The intervals must agree with a test of points one by one, also at coordinates of 1e6.
TEST(ShapeIntervals, AreWherePointsAreInside) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> place(-1, 4);
  for (const double offset : {0.0, 1e6}) {
    const auto at = [&](double x, double y, double z) { return Point{x + offset, y - offset, z + offset}; };
    const auto bar = shape_of(deck::Cylinder{at(0, 0, 0), at(3, 3, 1), 0.8});
    const auto ring = shape_of(difference({box(at(2, 0, 0), at(2.5, 3, 1)), box(at(2.2, 1, 0), at(2.3, 2, 1))}));
    const auto shape = shape_of(difference(
        {shape_of(union_of({box(at(0, 0, 0), at(3, 2, 2)), bar})), shape_of(deck::Sphere{at(1, 1, 1), 0.7}), ring}));
    for (int k = 0; k < 200; ++k) {
      const Point a = at(place(random), place(random), place(random));
      const Point b = at(place(random), place(random), place(random));
      const Intervals found = intervals_inside(shape, a, b, 3);
      for (double t = 0.00123; t < 1; t += 0.00497) {
        const Point x{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
        const bool in =
            std::any_of(found.begin(), found.end(), [&](const auto& one) { return one.first <= t && t <= one.second; });
        EXPECT_EQ(in, contains(shape, x, 3)) << k << " " << t;
      }
    }
  }
}

}  // namespace
}  // namespace perinox::body::fixture
