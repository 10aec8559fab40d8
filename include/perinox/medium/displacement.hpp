#pragma once
#include <cstdint>
#include <vector>

namespace perinox::medium {

/// A number that no other state of the program has. Every rank asks for numbers in the same order, so two states are
/// the same on all ranks where they are on one.
std::uint64_t new_version();

/// A displacement that something is asked for, [owned unknowns], and the number of its state: length. Whether it is the
/// displacement that was looked at before is a comparison of two numbers.
struct At {
  /// A displacement that has no number counts as a new state.
  At(const double* values) : displacement(values), version(new_version()) {}  // NOLINT: meant to convert
  At(const double* values, std::uint64_t number) : displacement(values), version(number) {}

  const double* displacement;
  std::uint64_t version;
};

/// A displacement with its number. Whoever may write into it gives it a new one.
class Displacement {
 public:
  Displacement() : version_(new_version()) {}
  explicit Displacement(std::vector<double> values) : values_(std::move(values)), version_(new_version()) {}

  const std::vector<double>& values() const { return values_; }
  std::vector<double>& change() {
    version_ = new_version();
    return values_;
  }
  At at() const { return {values_.data(), version_}; }

 private:
  std::vector<double> values_;
  std::uint64_t version_;
};

}  // namespace perinox::medium
