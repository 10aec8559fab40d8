#include "perinox/solve/coarse_grid.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <numeric>

#include "perinox/solve/coarse_pieces.hpp"

namespace perinox::solve {

CoarseGrid::CoarseGrid(const mechanics::Scene& scene, const std::vector<char>& prescribed,
                       const bonds::BondGraph& graph, double spacing)
    : scene_(scene), prescribed_(prescribed), cells_(scene.body(), spacing) {
  const body::Body& body = scene.body();
  const CoarsePieces pieces(scene, cells_, graph);
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
      const CoarseCells::Place place = cells_.cell_place(cell[i]);
      CoarseElement element{};
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

void CoarseGrid::shape_values(const CoarseElement& element, const double* x, double* values) const {
  for (int c = 0; c < cells_.corners(); ++c) {
    values[c] = 1;
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension()); ++a) {
      const double s = (x[a] - element.corner[a]) / cells_.size()[a];
      values[c] *= (c >> a & 1) != 0 ? s : 1 - s;
    }
  }
}

// Inside a cell a d-linear function is a sum of 2^d monomials, bit a of whose number says whether the coordinate on
// axis a is a factor. Particle by particle only monomials are used; the step between corner values and monomials is
// done once a cell, axis by axis.

// Components are padded to four, which fills the lanes of the processor's vectors.

namespace {

/// Values of the monomials at x.
template <int d>
Eigen::Matrix<double, 1, (1 << d)> monomials(const double* x, const CoarseElement& element, const double* over_size) {
  Eigen::Matrix<double, 1, (1 << d)> value;
  value[0] = 1;
  for (int a = 0; a < d; ++a) {
    const double s = (x[a] - element.corner[static_cast<std::size_t>(a)]) * over_size[a];
    for (int m = 0; m < 1 << a; ++m) value[m + (1 << a)] = s * value[m];
  }
  return value;
}

}  // namespace

template <int d>
void CoarseGrid::restrict_points(const double* r, double* coarse) const {
  constexpr int corners = 1 << d;
  using Sum = Eigen::Map<Eigen::Matrix<double, 4, corners>>;
  double over_size[d];
  for (int a = 0; a < d; ++a) over_size[a] = 1 / cells_.size()[static_cast<std::size_t>(a)];
  monomials_.assign(elements_.size() * corners * 4, 0.0);
  Eigen::Vector4d value = Eigen::Vector4d::Zero();
  // Particles in the order of memory: neighbours share an element, whose few sums stay near.
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const std::size_t first = static_cast<std::size_t>(i) * d;
    const auto e = static_cast<std::size_t>(element_[i]);
    for (int c = 0; c < d; ++c) value[c] = prescribed_[first + c] ? 0 : r[first + c];
    Sum(&monomials_[e * corners * 4]).noalias() +=
        value * monomials<d>(scene_.body().position(i), elements_[e], over_size);
  }
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    Sum sum(&monomials_[e * corners * 4]);
    for (int a = 0; a < d; ++a)
      for (int m = 0; m < corners; ++m)
        if ((m >> a & 1) == 0) sum.col(m) -= sum.col(m + (1 << a));
    for (int m = 0; m < corners; ++m)
      for (int c = 0; c < d; ++c) coarse[static_cast<std::size_t>(elements_[e].node[m]) * d + c] += sum(c, m);
  }
}

template <int d>
void CoarseGrid::interpolate_points(const double* coarse, double* z) const {
  constexpr int corners = 1 << d;
  using Coefficient = Eigen::Map<Eigen::Matrix<double, 4, corners>>;
  double over_size[d];
  for (int a = 0; a < d; ++a) over_size[a] = 1 / cells_.size()[static_cast<std::size_t>(a)];
  monomials_.assign(elements_.size() * corners * 4, 0.0);
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    Coefficient coefficient(&monomials_[e * corners * 4]);
    for (int m = 0; m < corners; ++m)
      for (int c = 0; c < d; ++c) coefficient(c, m) = coarse[static_cast<std::size_t>(elements_[e].node[m]) * d + c];
    for (int a = 0; a < d; ++a)
      for (int m = 0; m < corners; ++m)
        if ((m >> a & 1) == 0) coefficient.col(m + (1 << a)) -= coefficient.col(m);
  }
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    const std::size_t first = static_cast<std::size_t>(i) * d;
    const auto e = static_cast<std::size_t>(element_[i]);
    Eigen::Vector4d value;
    value.noalias() = Coefficient(&monomials_[e * corners * 4]) *
                      monomials<d>(scene_.body().position(i), elements_[e], over_size).transpose();
    for (int c = 0; c < d; ++c) z[first + c] += prescribed_[first + c] ? 0 : value[c];
  }
}

void CoarseGrid::restrict_to_nodes(const double* r, double* coarse) const {
  std::fill_n(coarse, unknowns(), 0.0);
  if (dimension() == 3)
    restrict_points<3>(r, coarse);
  else
    restrict_points<2>(r, coarse);
}

void CoarseGrid::add_interpolated(const double* coarse, double* z) const {
  if (dimension() == 3)
    interpolate_points<3>(coarse, z);
  else
    interpolate_points<2>(coarse, z);
}

std::size_t CoarseGrid::bytes() const {
  return elements_.capacity() * sizeof(CoarseElement) + (order_.capacity() + element_.capacity()) * sizeof(LocalIndex) +
         monomials_.capacity() * sizeof(double) + node_ids_.capacity() * sizeof(GlobalId) +
         node_positions_.capacity() * sizeof(double);
}

}  // namespace perinox::solve
