#include "candidates.hpp"

#include <algorithm>
#include <array>

#include "perinox/body/neighbor_search.hpp"

namespace perinox::bonds {

namespace {

/// Finds candidates with a k-d tree.
class Search : public Candidates {
 public:
  Search(const body::Body& body, const BondRule& rule, double reach)
      : body_(body), rule_(rule), reach_(reach), tree_(body.reference, body.dimension) {}
  void find(LocalIndex i, std::vector<FoundBond>& found) override {
    found.clear();
    tree_.within(body_.position(i), reach_, near_);
    if (body_.ghosts > 0)
      std::sort(near_.begin(), near_.end(), [&](LocalIndex a, LocalIndex b) { return body_.id[a] < body_.id[b]; });
    for (const LocalIndex j : near_) {
      if (!rule_.may_bond(i, j)) continue;
      const FoundBond bond = rule_.bond(i, j);
      if (moment(bond) > 0) found.push_back(bond);
    }
  }

 private:
  const body::Body& body_;
  const BondRule& rule_;
  double reach_;
  body::NeighborSearch tree_;
  std::vector<LocalIndex> near_;
};

/// Finds candidates on a lattice. Every particle has the same ones there, so the bonds are worked out once.
class Stencil : public Candidates {
 public:
  Stencil(const body::Body& body, const BondRule& rule, double reach, const CellGrid& grid)
      : body_(body), rule_(rule), grid_(grid) {
    const int r = static_cast<int>(reach / grid.spacing * (1 + 1e-10));
    const int flat = grid.dimension == 3 ? r : 0;
    for (int z = -flat; z <= flat; ++z)
      for (int y = -r; y <= r; ++y)
        for (int x = -r; x <= r; ++x) {
          if (x == 0 && y == 0 && z == 0) continue;
          const FoundBond bond = rule.lattice_bond(0, {x, y, z});
          if (bond.length > reach * (1 + 1e-10) || moment(bond) <= 0) continue;
          steps_.push_back({x, y, z});
          bonds_.push_back(bond);
        }
  }
  void find(LocalIndex i, std::vector<FoundBond>& found) override {
    found.clear();
    const auto at = grid_.position(grid_.cell[i]);
    bool ascending = true;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
      const LocalIndex j = grid_.neighbor(at, steps_[k]);
      if (j < 0 || !rule_.may_bond(i, j)) continue;
      ascending = ascending && (found.empty() || body_.id[found.back().neighbor] < body_.id[j]);
      found.push_back(bonds_[k]);
      found.back().neighbor = j;
      found.back().weight *= body_.volume[j];
    }
    if (ascending) return;
    std::sort(found.begin(), found.end(),
              [&](const FoundBond& a, const FoundBond& b) { return body_.id[a.neighbor] < body_.id[b.neighbor]; });
  }

 private:
  const body::Body& body_;
  const BondRule& rule_;
  const CellGrid& grid_;
  std::vector<std::array<int, 3>> steps_;
  std::vector<FoundBond> bonds_;
};

}  // namespace

std::unique_ptr<Candidates> make_candidates(const body::Body& body, const BondRule& rule, double reach,
                                            const CellGrid* grid) {
  if (grid) return std::make_unique<Stencil>(body, rule, reach, *grid);
  return std::make_unique<Search>(body, rule, reach);
}

}  // namespace perinox::bonds
