#include "perinox/grid/background_grid.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "node_copies.hpp"
#include "perinox/core/widest.hpp"

namespace perinox::grid {

BackgroundGrid::BackgroundGrid(const body::Body& body, const std::vector<char>& prescribed,
                               const std::vector<double>& damage, const bonds::BondGraph& graph, double spacing)
    : body_(body), prescribed_(prescribed), cells_(body, spacing) {
  const NodeCopies pieces(body, damage, cells_, graph);
  const auto owned = static_cast<std::size_t>(body.owned);

  std::vector<GlobalId> cell(owned);
  for (LocalIndex i = 0; i < body.owned; ++i) cell[i] = cells_.cell_at(body.position(i));
  order_.resize(owned);
  element_.resize(owned);
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&](LocalIndex a, LocalIndex b) {
    if (cell[a] != cell[b]) return cell[a] < cell[b];
    const GlobalId pa = pieces.piece(a), pb = pieces.piece(b);
    return pa != pb ? pa < pb : a < b;
  });

  const auto corners = static_cast<std::size_t>(cells_.corners());
  std::vector<GlobalId> ids;  // [elements * corners]
  for (std::size_t k = 0; k < owned; ++k) {
    const LocalIndex i = order_[k];
    const bool same = k > 0 && cell[i] == cell[order_[k - 1]] && pieces.piece(i) == pieces.piece(order_[k - 1]);
    if (!same) {
      const Cells::Place place = cells_.cell_place(cell[i]);
      GridElement element{};
      element.corner = cells_.position(place);
      element.begin = static_cast<LocalIndex>(k);
      for (int c = 0; c < cells_.corners(); ++c)
        ids.push_back(pieces.copy_of(cells_.node_at(place, c), pieces.piece(i)));
      elements_.push_back(element);
    }
    elements_.back().end = static_cast<LocalIndex>(k) + 1;
    element_[i] = static_cast<LocalIndex>(elements_.size()) - 1;
  }
  node_ids_ = ids;
  std::sort(node_ids_.begin(), node_ids_.end());
  node_ids_.erase(std::unique(node_ids_.begin(), node_ids_.end()), node_ids_.end());
  node_ids_.shrink_to_fit();
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (std::size_t c = 0; c < corners; ++c) {
      const auto at = std::lower_bound(node_ids_.begin(), node_ids_.end(), ids[e * corners + c]);
      elements_[e].node[c] = static_cast<LocalIndex>(at - node_ids_.begin());
    }
  for (const GlobalId id : node_ids_) {
    const std::array<double, 3> x = cells_.position(cells_.node_place(pieces.original(id)));
    node_positions_.insert(node_positions_.end(), x.begin(), x.begin() + dimension());
  }
}

void BackgroundGrid::shape_values(const GridElement& element, const double* x, double* values) const {
  for (int c = 0; c < cells_.corners(); ++c) {
    values[c] = 1;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension()); ++a) {
      const double s = (x[a] - element.corner[a]) / cells_.size()[a];
      values[c] *= (c >> a & 1) != 0 ? s : 1 - s;
    }
  }
}

// Inside a cell a d-linear function is a sum of 2^d monomials. Bit a of a monomial's number says whether the coordinate
// on axis a is a factor. The loops over particles use monomials only, with the components of a vector side by side in
// one register. The step between corner values and monomials is taken once a cell, axis by axis.

namespace {

/// Numbers stored for each monomial: the components, and in 3-D one more to fill the register.
constexpr int lanes_of(int dimension) { return dimension == 3 ? 4 : 2; }

/// The data that the loops over particles read, as plain pointers.
struct Points {
  LocalIndex count;
  const double* place;
  const LocalIndex* element;
  const GridElement* elements;
  const char* prescribed;
  std::array<double, 3> over_size;
};

Points points_of(const body::Body& body, const std::vector<char>& prescribed, const Cells& cells,
                 const std::vector<LocalIndex>& element, const std::vector<GridElement>& elements) {
  Points points{body.owned, body.reference.data(), element.data(), elements.data(), prescribed.data(), {}};
  for (std::size_t a = 0; a < static_cast<std::size_t>(cells.dimension()); ++a)
    points.over_size[a] = 1 / cells.size()[a];
  return points;
}

constexpr int top_bit(int m) { return m < 2 ? 0 : m < 4 ? 1 : 2; }

template <int d>
struct Lanes {
  typedef double Vector __attribute__((vector_size(8 * lanes_of(d)), may_alias));
};

/// Adds the particles' values r into the sums of their elements' monomials. Particles are visited in the order of
/// memory: neighbours share an element, so its few sums stay in the cache. sums: [elements][2^d][lanes].
template <int d>
inline __attribute__((always_inline)) void sum_monomials(const Points& p, const double* r, double* sums) {
  using Vector = typename Lanes<d>::Vector;
  for (LocalIndex i = 0; i < p.count; ++i) {
    const std::size_t first = static_cast<std::size_t>(i) * d;
    const auto e = static_cast<std::size_t>(p.element[i]);
    const double* corner = p.elements[e].corner.data();
    double s[d];
#pragma GCC unroll 3
    for (int a = 0; a < d; ++a) s[a] = (p.place[first + a] - corner[a]) * p.over_size[a];
    Vector force = Vector{};
#pragma GCC unroll 3
    for (int c = 0; c < d; ++c) force[c] = p.prescribed[first + c] ? 0 : r[first + c];
    Vector terms[1 << d];
    terms[0] = force;
#pragma GCC unroll 8
    for (int m = 1; m < 1 << d; ++m) terms[m] = terms[m - (1 << top_bit(m))] * s[top_bit(m)];
    auto* sum = reinterpret_cast<Vector*>(sums + (e << d) * lanes_of(d));
#pragma GCC unroll 8
    for (int m = 0; m < 1 << d; ++m) sum[m] += terms[m];
  }
}

template <int d>
inline __attribute__((always_inline)) void add_monomials(const Points& p, const double* coefficients, double* z) {
  using Vector = typename Lanes<d>::Vector;
  for (LocalIndex i = 0; i < p.count; ++i) {
    const std::size_t first = static_cast<std::size_t>(i) * d;
    const auto e = static_cast<std::size_t>(p.element[i]);
    const double* corner = p.elements[e].corner.data();
    const auto* coefficient = reinterpret_cast<const Vector*>(coefficients + (e << d) * lanes_of(d));
    double s[d];
#pragma GCC unroll 3
    for (int a = 0; a < d; ++a) s[a] = (p.place[first + a] - corner[a]) * p.over_size[a];
    Vector value[1 << d];
#pragma GCC unroll 8
    for (int m = 0; m < 1 << d; ++m) value[m] = coefficient[m];
#pragma GCC unroll 8
    for (int m = (1 << d) - 1; m > 0; --m) value[m - (1 << top_bit(m))] += value[m] * s[top_bit(m)];
#pragma GCC unroll 3
    for (int c = 0; c < d; ++c) z[first + c] += p.prescribed[first + c] ? 0 : value[0][c];
  }
}

PERINOX_WIDEST void sum_3(const Points& p, const double* r, double* sums) { sum_monomials<3>(p, r, sums); }
PERINOX_WIDEST void sum_2(const Points& p, const double* r, double* sums) { sum_monomials<2>(p, r, sums); }
PERINOX_WIDEST void add_3(const Points& p, const double* coefficients, double* z) {
  add_monomials<3>(p, coefficients, z);
}
PERINOX_WIDEST void add_2(const Points& p, const double* coefficients, double* z) {
  add_monomials<2>(p, coefficients, z);
}

}  // namespace

void BackgroundGrid::restrict_to_nodes(const double* r, double* coarse) const {
  std::fill_n(coarse, unknowns(), 0.0);
  const int d = dimension(), corners = cells_.corners();
  const Points points = points_of(body_, prescribed_, cells_, element_, elements_);
  clear_monomials();
  (d == 3 ? sum_3 : sum_2)(points, r, monomials());
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int c = 0; c < d; ++c) {
      double* sum = monomials() + e * corners * lanes_of(d) + c;
      for (int a = 0; a < d; ++a)
        for (int m = 0; m < corners; ++m)
          if ((m >> a & 1) == 0) sum[m * lanes_of(d)] -= sum[(m + (1 << a)) * lanes_of(d)];
      for (int m = 0; m < corners; ++m)
        coarse[static_cast<std::size_t>(elements_[e].node[m]) * d + c] += sum[m * lanes_of(d)];
    }
}

void BackgroundGrid::add_interpolated(const double* coarse, double* z) const {
  const int d = dimension(), corners = cells_.corners();
  const Points points = points_of(body_, prescribed_, cells_, element_, elements_);
  clear_monomials();
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (int c = 0; c < d; ++c) {
      double* coefficient = monomials() + e * corners * lanes_of(d) + c;
      for (int m = 0; m < corners; ++m)
        coefficient[m * lanes_of(d)] = coarse[static_cast<std::size_t>(elements_[e].node[m]) * d + c];
      for (int a = 0; a < d; ++a)
        for (int m = 0; m < corners; ++m)
          if ((m >> a & 1) == 0) coefficient[(m + (1 << a)) * lanes_of(d)] -= coefficient[m * lanes_of(d)];
    }
  (d == 3 ? add_3 : add_2)(points, monomials(), z);
}

void BackgroundGrid::clear_monomials() const {
  // The start is aligned to registers of eight numbers, and eight more numbers leave room to find the first such place.
  monomials_.assign(elements_.size() * static_cast<std::size_t>(lanes_of(dimension()) * cells_.corners()) + 8, 0.0);
}

double* BackgroundGrid::monomials() const {
  const auto at = reinterpret_cast<std::uintptr_t>(monomials_.data());
  return monomials_.data() + (64 - at % 64) % 64 / sizeof(double);
}

std::size_t BackgroundGrid::bytes() const {
  return elements_.capacity() * sizeof(GridElement) + (order_.capacity() + element_.capacity()) * sizeof(LocalIndex) +
         monomials_.capacity() * sizeof(double) + node_ids_.capacity() * sizeof(GlobalId) +
         node_positions_.capacity() * sizeof(double);
}

}  // namespace perinox::grid
