#pragma once
/// Point clouds for bodies that a box cannot make: lattices turned against the body, and jittered ones.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <string>

namespace perinox::test {

/// A bar of width x width x length along z, with its axis at x = y = 0 and its foot at z = 0. It is filled with a cubic
/// lattice of spacing 1 that is turned by `degrees` about y; at 45 the bar lies along [110]. jitter: of every
/// coordinate of every particle. The file lives as long as this object.
class BarCloud {
 public:
  BarCloud(int width, int length, double degrees, double jitter = 0)
      : file_(::testing::TempDir() + "perinox_bar_cloud.csv") {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> step(-jitter, jitter);
    std::ofstream out(file_);
    out.precision(17);
    out << "x,y,z,volume\n";
    const double angle = degrees * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
    const int reach = width + length;
    for (int k = -reach; k < reach; ++k)
      for (int i = -reach; i < reach; ++i) {
        const double x = c * (i + 0.5) + s * (k + 0.5), z = length / 2.0 - s * (i + 0.5) + c * (k + 0.5);
        if (std::abs(x) >= width / 2.0 || z <= 0 || z >= length) continue;
        for (int j = 0; j < width; ++j) {
          out << x + step(generator) << ',' << j + 0.5 - width / 2.0 + step(generator) << ',';
          out << z + step(generator) << ",1\n";
          ++particles_;
        }
      }
  }
  ~BarCloud() { std::remove(file_.c_str()); }
  BarCloud(const BarCloud&) = delete;
  BarCloud& operator=(const BarCloud&) = delete;

  std::string shape() const { return "{file: " + file_ + "}"; }
  std::size_t particles() const { return particles_; }

 private:
  std::string file_;
  std::size_t particles_ = 0;
};

}  // namespace perinox::test
