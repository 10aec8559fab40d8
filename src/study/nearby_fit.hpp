#pragma once
#include <memory>
#include <vector>

namespace perinox::study {

/// Values of scattered points at any place. It fits a quadratic to the nearest points, weighted by the inverse square
/// of their distance (moving least squares). It is exact for quadratic fields where the points around do not lie on one
/// conic.
class NearbyFit {
 public:
  /// positions: [n * 3], the third zero in 2-D; values: [n * columns]; dimension 2 or 3.
  NearbyFit(std::vector<double> positions, std::vector<double> values, int columns, int dimension);
  ~NearbyFit();
  NearbyFit(const NearbyFit&) = delete;
  NearbyFit& operator=(const NearbyFit&) = delete;

  /// Values at a place of 3 coordinates. [columns]
  std::vector<double> at(const double* place) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace perinox::study
