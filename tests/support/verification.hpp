#pragma once
/// Rows of the tables in docs/verification.md. A test prints its rows. With PERINOX_VERIFICATION_ROWS=FILE it also
/// appends them to that file, and with PERINOX_VERIFICATION=full it goes on to the finer resolutions
/// (scripts/verification.sh sets both).
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "support/measured.hpp"

namespace perinox::test {

/// True if the finer resolutions of the page are asked for, which the normal test run leaves out.
inline bool full_verification() {
  const char* word = std::getenv("PERINOX_VERIFICATION");
  return word != nullptr && std::string(word) == "full";
}

/// The given resolutions, and the finer ones if they are asked for.
inline std::vector<int> resolutions(std::vector<int> always, const std::vector<int>& finer) {
  if (full_verification()) always.insert(always.end(), finer.begin(), finer.end());
  return always;
}

/// One problem of one table, solved at growing resolutions. CPU time runs from one row to the next.
class Verification {
 public:
  /// table: the name of the table in docs/verification.md. source: who gives the exact answer.
  Verification(std::string table, std::string problem, std::string source)
      : table_(std::move(table)), problem_(std::move(problem)), source_(std::move(source)) {}

  /// Writes a row and returns the error relative to the exact answer (with sign where that means something).
  double row(const std::string& quadrature, const std::string& resolution, std::size_t particles, double error) {
    return write(quadrature, resolution, particles, error, "");
  }

  /// Writes a row with the observed order, log(previous error / error) / log(fineness / previous fineness), if the row
  /// before has the same quadrature and an error of the same sign; otherwise without.
  double converging(const std::string& quadrature, const std::string& resolution, std::size_t particles, double error,
                    double fineness) {
    order_ = quadrature == quadrature_ ? std::log(error_ / error) / std::log(fineness / fineness_) : std::nan("");
    quadrature_ = quadrature, error_ = error, fineness_ = fineness;
    return write(quadrature, resolution, particles, error, order_ == order_ ? fmt::format("{:.2f}", order_) : "");
  }

  /// The observed order of the last row. If it has none it is not-a-number, which no EXPECT_GE accepts.
  double order() const { return order_; }

 private:
  double write(const std::string& quadrature, const std::string& resolution, std::size_t particles, double error,
               const std::string& order) {
    const double seconds = static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC;
    const std::string line = fmt::format("{};{};{};{};{};{};{:.2e};{};{:.2f}", table_, problem_, source_, quadrature,
                                         resolution, particles, error, order, seconds);
    std::printf("[ row      ] %s\n", line.c_str());
    if (const char* file = std::getenv("PERINOX_VERIFICATION_ROWS")) std::ofstream(file, std::ios::app) << line << '\n';
    start_ = std::clock();
    return measured(table_ + ": " + problem_ + ", " + quadrature + ", " + resolution, error);
  }

  std::string table_, problem_, source_, quadrature_;
  double error_ = 0, fineness_ = 0, order_ = std::nan("");
  std::clock_t start_ = std::clock();
};

}  // namespace perinox::test
