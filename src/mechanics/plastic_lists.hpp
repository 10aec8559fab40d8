#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "perinox/mechanics/plastic_extension.hpp"

namespace perinox::mechanics {

/// Plastic extension as lists for a saved state: for each particle e_p at its own ends of its bonds, in ascending id of
/// the neighbour, 0 where nothing has flowed; an order that depends neither on the layout of the loops nor on the
/// ranks. Made once for all portions of a state: for pairs it holds 4 bytes a pair.
class PlasticLists {
 public:
  explicit PlasticLists(const Scene& scene);
  ~PlasticLists();
  PlasticLists(PlasticLists&&) noexcept;

  /// Appended to `values`, the bonds of one particle after the other.
  void read(const PlasticExtension& extension, const std::vector<LocalIndex>& particles, std::vector<double>& values);
  /// The way back, into chunks that are there; values for others are passed over.
  void write(PlasticExtension& extension, const std::vector<LocalIndex>& particles, const std::vector<double>& values);

 private:
  class Order;
  class OfLattice;
  class OfPairs;
  std::unique_ptr<Order> order_;
};

}  // namespace perinox::mechanics
