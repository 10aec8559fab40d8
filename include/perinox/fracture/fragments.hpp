#pragma once
#include <vector>

#include "perinox/medium/model.hpp"

namespace perinox::fracture {

/// The fragments of a body: what chains of intact bonds hold together.
class Fragments {
 public:
  explicit Fragments(const medium::Model& model) : model_(model) {}

  /// From the bonds as they are; about a sweep over the families. Collective.
  void find();
  /// [owned] number of each particle's fragment; by smallest particle id, from 0, alike on any number of ranks.
  const std::vector<double>& number() const { return number_; }
  long long several() const { return several_; }  ///< fragments of more than one particle, over all ranks
  long long single() const { return single_; }    ///< particles without a bond, over all ranks

 private:
  const medium::Model& model_;
  std::vector<double> number_;
  long long several_ = 0, single_ = 0;
};

}  // namespace perinox::fracture
