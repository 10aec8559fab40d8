#pragma once
#include <vector>

#include "perinox/body/body.hpp"
#include "perinox/body/crack_surface.hpp"

namespace perinox::bonds {

/// The deck's pre-cracks and the number of bonds that each has cut. Deck and body must outlive it.
class PreCracks {
 public:
  /// reach: length of the longest bond. Throws InputError for a crack without an area.
  PreCracks(const deck::Deck& deck, const body::Body& body, double horizon, double reach);

  /// Finds the surfaces that come near particle i, whose bonds are asked for next.
  void approach(LocalIndex i);
  /// True if one of these surfaces cuts the bond between i and j. Every surface counts the bonds that it cuts.
  bool cut(LocalIndex i, LocalIndex j);
  /// Checks the pre-cracks once all bonds are known. Throws InputError on all ranks together: for a crack that cuts no
  /// bond, and for one that runs through the centre of a particle, which would be on neither side of it. Collective.
  void refuse_unclear() const;

 private:
  const deck::Deck& deck_;
  const body::Body& body_;
  double reach_ = 0;
  std::vector<body::CrackSurface> surfaces_;
  std::vector<long long> cut_by_;
  std::vector<std::size_t> near_;
  std::vector<std::vector<LocalIndex>> held_;  ///< [surfaces] owned particles that lie in each surface
};

}  // namespace perinox::bonds
