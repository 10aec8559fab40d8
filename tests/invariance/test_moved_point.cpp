/// A point of a cloud that moves a little changes the answer a little: in proportion to its way, with the slope that a
/// difference over a longer way has.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lot.hpp"
#include "support/measured.hpp"
#include "workshop.hpp"

namespace perinox::invariance {
namespace {

/// The answer of a plate of 12 x 8 points or a bar of 9 x 4 x 4, jittered or not, whose point `moved` is off by `way`.
/// The distance of no other pair of points differs from the horizon by less than 0.004 of it.
Answer answer_with(const std::string& folder, bool solid, double jitter, std::size_t moved, const Vector3& way) {
  Lot lot(5);
  const int size[3] = {solid ? 9 : 12, solid ? 4 : 8, solid ? 4 : 1};
  std::ofstream out(folder + "/points.csv");
  out << "x,y,z,volume\n";
  std::size_t row = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i, ++row) {
        Vector3 x{i + 0.5 + lot.between(-jitter, jitter), j + 0.5 + lot.between(-jitter, jitter),
                  solid ? k + 0.5 + lot.between(-jitter, jitter) : 0};
        for (std::size_t c = 0; c < (solid ? 3U : 2U) && row == moved; ++c) x[c] += way[c];
        out << digits(x[0]) << ',' << digits(x[1]) << ',' << digits(x[2]) << ",1\n";
      }
  out.close();
  const std::string z = solid ? ", z: 0" : "";
  return answer_of(fmt::format(R"(
dimension: {}
body: [{{name: a, shape: {{file: points.csv}}, spacing: 1, material: m}}]
horizon: {{length: 2.62}}
materials: {{m: {{model: elastic, young_modulus: 1000, poisson_ratio: 0.3}}}}
sets: {{left: {{where: "x < 2"}}, right: {{where: "x > {}"}}}}
boundary:
  - {{set: left, displacement: {{x: 0, y: 0{}}}}}
  - {{set: right, displacement: {{x: "0.05*t", y: "0.02*t"{}}}}}
steps: {{end: 1, count: 1}}
solver:
  newton: {{tolerance: 1e-14, update_tolerance: 1e-13, max_iterations: 60, forcing: constant}}
  linear: {{tolerance: 1e-10}}
)",
                               solid ? "3" : "plane-strain", size[0] - 2, z, z),
                   folder, MPI_COMM_SELF);
}

std::vector<double> slope(const std::string& folder, bool solid, double jitter, std::size_t moved, double way) {
  const Vector3 there{way, -0.7 * way, 0.4 * way}, back{-way, 0.7 * way, -0.4 * way};
  const Answer a = answer_with(folder, solid, jitter, moved, there),
               b = answer_with(folder, solid, jitter, moved, back);
  std::vector<double> difference = a.fields.at("displacement").values;
  const std::vector<double>& other = b.fields.at("displacement").values;
  for (std::size_t u = 0; u < difference.size(); ++u) difference[u] = (difference[u] - other[u]) / (2 * way);
  return difference;
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values)
    if (!(std::abs(value) <= most)) most = std::abs(value);
  return most;
}

TEST(MovedPoint, TheAnswerHasASlope) {
  for (const bool solid : {false, true})
    for (const double jitter : {0.0, 0.1}) {
      const WorkFolder folder;
      const std::size_t moved = solid ? 58 : 42;
      const std::vector<double> wide = slope(folder.path(), solid, jitter, moved, 1e-4);
      const std::vector<double> narrow = slope(folder.path(), solid, jitter, moved, 1e-6);
      std::vector<double> apart = wide;
      for (std::size_t u = 0; u < apart.size(); ++u) apart[u] -= narrow[u];
      const std::string name = fmt::format("{}, jitter {}", solid ? "3-D" : "2-D", jitter);
      EXPECT_LE(test::measured("slopes over ways of 1e-4 and 1e-6 apart, " + name, largest(apart) / largest(wide)),
                1e-5);

      // A billionth of a spacing is enough to change any test of whether points lie on a lattice.
      const Answer at = answer_with(folder.path(), solid, jitter, moved, {}),
                   near = answer_with(folder.path(), solid, jitter, moved, {1e-9, 0, 0});
      const double change = deviation(at, near, {}, Rows::none, false);
      EXPECT_LE(test::measured("change by a way of 1e-9, " + name, change), 1e-8);
    }
}

}  // namespace
}  // namespace perinox::invariance
