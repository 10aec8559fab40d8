#pragma once
/// Tolerances in these tests stand beside the value measured when they were written. This header keeps the largest
/// value seen under each name and prints the list when the program ends, so that running the tests checks the comments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace perinox::test {

class MeasuredReport : public ::testing::Environment {
 public:
  static std::map<std::string, double>& largest() {
    static std::map<std::string, double> values;
    return values;
  }
  void TearDown() override {
    for (const auto& [what, value] : largest()) std::printf("[ measured ] %-66s %.3g\n", what.c_str(), value);
  }
};

inline ::testing::Environment* const measured_report = ::testing::AddGlobalTestEnvironment(new MeasuredReport);

/// Notes the value and returns it. Not-a-number stays not-a-number, which no EXPECT_LE accepts.
inline double measured(const std::string& what, double value) {
  auto [place, first] = MeasuredReport::largest().emplace(what, value);
  if (!first) place->second = value > place->second || value != value ? value : place->second;
  return value;
}

}  // namespace perinox::test
