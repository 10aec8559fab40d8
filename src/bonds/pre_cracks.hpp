#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/body/crack_surface.hpp"

namespace perinox::bonds {

/// The deck's pre-cracks, and how many bonds each has cut. Both arguments must outlive it.
class PreCracks {
 public:
  /// reach: length of the longest bond.
  PreCracks(const deck::Deck& deck, const body::Body& body, double horizon, double reach);

  /// Which surfaces come near particle i, whose bonds are asked for next.
  void approach(LocalIndex i);
  /// True if one of them cuts the bond between i and j; counts it.
  bool cut(LocalIndex i, LocalIndex j);
  /// Collective. Throws InputError on all ranks together: at a crack that cuts no bond, and at one that runs through
  /// the centre of a particle, which would be on neither side of it.
  void refuse_unclear() const;

 private:
  const deck::Deck& deck_;
  const body::Body& body_;
  double reach_ = 0;
  std::vector<body::CrackSurface> surfaces_;
  std::vector<long long> cut_by_;
  std::vector<std::size_t> near_;
  std::vector<std::vector<LocalIndex>> held_;  ///< of each surface: owned particles in it
};

}  // namespace perinox::bonds
