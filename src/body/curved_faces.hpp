#pragma once
#include <map>
#include <memory>
#include <vector>

#include "perinox/body/cut_cells.hpp"
#include "perinox/body/exposed_faces.hpp"
#include "perinox/body/neighbor_search.hpp"

namespace perinox::body {

/// The surface that cuts cells of lattices, and who carries the loads on it.
class CurvedFaces {
 public:
  CurvedFaces(const deck::Deck& deck, const Body& body)
      : deck_(deck), body_(body), search_(body.reference, body.dimension) {}

  /// True where the face of particle i's cell is not the surface, because the surface cuts this cell or the next.
  bool replaces(LocalIndex i, int axis, int side);
  /// What owned particles carry of the surface in and around the cells of the particles in `set` [owned]. Collective.
  std::vector<FaceShare> shares(const std::vector<LocalIndex>& set);

 private:
  CutCells* cells_of(int part);
  bool against_another(const CutCells::Patch& patch, int part) const;
  void add(const CutCells::Patch& patch, double weight, LocalIndex i, std::vector<FaceShare>& shares) const;

  const deck::Deck& deck_;
  const Body& body_;
  NeighborSearch search_;
  std::map<int, std::unique_ptr<CutCells>> cells_;  ///< of each part
};

}  // namespace perinox::body
