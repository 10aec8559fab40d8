#include "assembled_tangent.hpp"

#include <Tpetra_CrsGraph.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Map.hpp>
#include <algorithm>
#include <array>

#include "perinox/medium/tangent.hpp"

namespace perinox::mechanics {

AssembledTangent::AssembledTangent(const Scene& scene, const std::vector<char>& prescribed)
    : scene_(scene), prescribed_(prescribed) {
  build_pattern();

  const int d = scene.dimension();
  const auto local = static_cast<std::size_t>(scene.local());
  using Device = tpetra::Graph::local_graph_device_type;
  Device::row_map_type::non_const_type begin("row begin", local * d + 1);
  Device::entries_type::non_const_type columns("columns", column_.size() * d * d);
  std::size_t position = 0;
  for (std::size_t a = 0; a < local; ++a)
    for (int c = 0; c < d; ++c) {
      begin(a * d + c) = position;
      for (std::size_t k = row_begin_[a]; k < row_begin_[a + 1]; ++k)
        for (int e = 0; e < d; ++e) columns(position++) = column_[k] * d + e;
    }
  begin(local * d) = position;

  const auto owned_map = medium::unknowns_map(scene.body());
  const auto local_map = medium::local_unknowns_map(scene.body());
  auto graph = Teuchos::rcp(new tpetra::Graph(local_map, local_map, begin, columns));
  graph->fillComplete(owned_map, owned_map);
  contributions_ = Teuchos::rcp(new tpetra::Matrix(graph));
  if (scene.body().communicator.size() == 1) {
    matrix_ = contributions_;
    return;
  }
  to_owners_ = Teuchos::rcp(new tpetra::Export(local_map, owned_map));
  auto owned_graph = Tpetra::exportAndFillCompleteCrsGraph<tpetra::Graph>(graph, *to_owners_, owned_map, owned_map);
  matrix_ = Teuchos::rcp(new tpetra::Matrix(owned_graph));
}

void AssembledTangent::build_pattern() {
  const bonds::Bonds& bonds = scene_.bonds();
  const auto local = static_cast<std::size_t>(scene_.local());
  touching_begin_.assign(local + 1, 0);
  for (LocalIndex i = 0; i < scene_.owned(); ++i) ++touching_begin_[static_cast<std::size_t>(i) + 1];
  for (const LocalIndex j : bonds.neighbor) ++touching_begin_[static_cast<std::size_t>(j) + 1];
  for (std::size_t a = 0; a < local; ++a) touching_begin_[a + 1] += touching_begin_[a];
  touching_.resize(touching_begin_.back());
  std::vector<std::size_t> next(touching_begin_.begin(), touching_begin_.end() - 1);
  for (LocalIndex i = 0; i < scene_.owned(); ++i) {
    touching_[next[i]++] = {i, -1};
    for (int j = 0; j < bonds.family_size(i); ++j) {
      const auto a = static_cast<std::size_t>(bonds.neighbor[bonds.offset[i] + j]);
      touching_[next[a]++] = {i, j};
    }
  }

  std::vector<std::size_t> seen(local, local);
  row_begin_.assign(1, 0);
  for (std::size_t a = 0; a < local; ++a) {
    auto add = [&](LocalIndex k) {
      if (seen[k] == a) return;
      seen[k] = a;
      column_.push_back(k);
    };
    for (std::size_t s = touching_begin_[a]; s < touching_begin_[a + 1]; ++s) {
      const LocalIndex i = touching_[s].centre;
      add(i);
      for (std::int64_t b = bonds.offset[i]; b < bonds.offset[i + 1]; ++b) add(bonds.neighbor[b]);
    }
    std::sort(column_.begin() + static_cast<std::ptrdiff_t>(row_begin_.back()), column_.end());
    row_begin_.push_back(column_.size());
  }
}

namespace {

constexpr int max_rank = materials::ModulusState::max_rank;

/// p and q of every rank-one term at the centre of a family, each minus its sum over the family: [rank][p, q][d].
template <int d>
using CentreTerms = std::array<double, 2 * max_rank * d>;

template <int d>
std::vector<CentreTerms<d>> centre_terms(const Scene& scene, const StoredTangent& tangent) {
  const bonds::Bonds& bonds = scene.bonds();
  std::vector<CentreTerms<d>> centre(static_cast<std::size_t>(scene.owned()));
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const auto particle = static_cast<LocalIndex>(i);
    const std::int64_t first = bonds.offset[i];
    centre[i].fill(0.0);
    for (int r = 0; r < tangent.rank(particle); ++r) {
      const StoredTangent::Term& term = tangent.term(particle, r);
      for (int j = 0; j < bonds.family_size(particle); ++j) {
        const double w = bonds.weight[first + j];
        const double* m = tangent.direction(first + j);
        for (int c = 0; c < d; ++c) {
          centre[i][2 * r * d + c] -= StoredTangent::entry(term.p, bonds, first, j) * w * m[c];
          centre[i][(2 * r + 1) * d + c] -= StoredTangent::entry(term.q, bonds, first, j) * w * m[c];
        }
      }
    }
  }
  return centre;
}

/// The d rows of one particle, into which families add.
template <int d>
struct ParticleRows {
  const Scene& scene;
  const StoredTangent& tangent;
  const std::vector<CentreTerms<d>>& centre;
  const std::vector<std::size_t>& place;  ///< [local] column of a particle within the rows
  double* rows;
  std::size_t width;

  /// The bond-wise part of bond j of the family of i.
  void add_bond(LocalIndex i, int j, std::size_t column, double sign) const {
    const bonds::Bonds& bonds = scene.bonds();
    const std::int64_t b = bonds.offset[i] + j;
    const double* m = tangent.direction(b);
    const double g = tangent.geometric(b);
    const double w = sign * scene.body().volume[i] * bonds.weight[b];
    for (int c = 0; c < d; ++c)
      for (int e = 0; e < d; ++e)
        rows[static_cast<std::size_t>(c) * width + column + e] +=
            w * ((tangent.diagonal(b) - g) * m[c] * m[e] + (c == e ? g : 0.0));
  }

  void add_outer(std::size_t column, const double* left, const double* right) const {
    for (int c = 0; c < d; ++c)
      for (int e = 0; e < d; ++e) rows[static_cast<std::size_t>(c) * width + column + e] += left[c] * right[e];
  }

  /// Rank-one term r of the family of i; the rows are those of its neighbour ja, or of i itself where ja is -1.
  void add_term(LocalIndex i, int ja, int r) const {
    const bonds::Bonds& bonds = scene.bonds();
    const StoredTangent::Term& term = tangent.term(i, r);
    const std::int64_t first = bonds.offset[i];
    double left[d];
    for (int c = 0; c < d; ++c)
      left[c] = scene.body().volume[i] * term.coefficient *
                (ja >= 0 ? StoredTangent::entry(term.p, bonds, first, ja) * bonds.weight[first + ja] *
                               tangent.direction(first + ja)[c]
                         : centre[i][2 * r * d + c]);
    add_outer(place[i], left, &centre[i][(2 * r + 1) * d]);
    for (int j = 0; j < bonds.family_size(i); ++j) {
      const double q = StoredTangent::entry(term.q, bonds, first, j) * bonds.weight[first + j];
      const double* m = tangent.direction(first + j);
      double right[d];
      for (int e = 0; e < d; ++e) right[e] = q * m[e];
      add_outer(place[bonds.neighbor[first + j]], left, right);
    }
  }

  /// The family of i: the particle of the rows is its neighbour ja, or i itself where ja is -1.
  void add_family(LocalIndex i, int ja, std::size_t own) const {
    const bonds::Bonds& bonds = scene.bonds();
    if (ja >= 0) {
      add_bond(i, ja, own, 1);
      add_bond(i, ja, place[i], -1);
    } else {
      for (int j = 0; j < bonds.family_size(i); ++j) {
        add_bond(i, j, own, 1);
        add_bond(i, j, place[bonds.neighbor[bonds.offset[i] + j]], -1);
      }
    }
    for (int r = 0; r < tangent.rank(i); ++r) add_term(i, ja, r);
  }
};

}  // namespace

template <int d>
void AssembledTangent::fill_rows(const StoredTangent& tangent, double prescribed_diagonal, double* values) const {
  const auto owned = static_cast<std::size_t>(scene_.owned());
  const std::vector<CentreTerms<d>> centre = centre_terms<d>(scene_, tangent);
  std::vector<std::size_t> place(static_cast<std::size_t>(scene_.local()));
  for (std::size_t a = 0; a < static_cast<std::size_t>(scene_.local()); ++a) {
    const std::size_t width = (row_begin_[a + 1] - row_begin_[a]) * d;
    double* rows = values + row_begin_[a] * d * d;
    std::fill(rows, rows + width * d, 0.0);
    for (std::size_t k = row_begin_[a]; k < row_begin_[a + 1]; ++k) place[column_[k]] = (k - row_begin_[a]) * d;
    const ParticleRows<d> of_particle{scene_, tangent, centre, place, rows, width};
    for (std::size_t s = touching_begin_[a]; s < touching_begin_[a + 1]; ++s)
      of_particle.add_family(touching_[s].centre, touching_[s].place, place[a]);

    for (int c = 0; c < d; ++c) {
      double* row = rows + static_cast<std::size_t>(c) * width;
      if (prescribed_[a * d + c]) {
        std::fill(row, row + width, 0.0);
        if (a < owned) row[place[a] + static_cast<std::size_t>(c)] = prescribed_diagonal;
        continue;
      }
      for (std::size_t k = row_begin_[a]; k < row_begin_[a + 1]; ++k)
        for (int e = 0; e < d; ++e)
          if (prescribed_[static_cast<std::size_t>(column_[k]) * d + e]) row[(k - row_begin_[a]) * d + e] = 0;
    }
  }
}

void AssembledTangent::fill(const StoredTangent& tangent, double prescribed_diagonal) {
  if (contributions_->isFillComplete()) contributions_->resumeFill();
  {
    const auto local = contributions_->getLocalMatrixHost();
    if (scene_.dimension() == 3)
      fill_rows<3>(tangent, prescribed_diagonal, local.values.data());
    else
      fill_rows<2>(tangent, prescribed_diagonal, local.values.data());
  }
  const auto owned_map = matrix_->getCrsGraph()->getDomainMap();
  contributions_->fillComplete(owned_map, owned_map);
  if (matrix_ == contributions_) return;
  if (matrix_->isFillComplete()) matrix_->resumeFill();
  matrix_->setAllToScalar(0.0);
  matrix_->doExport(*contributions_, *to_owners_, Tpetra::ADD);
  matrix_->fillComplete(owned_map, owned_map);
}

long long AssembledTangent::nonzeros() const { return static_cast<long long>(matrix_->getGlobalNumEntries()); }

}  // namespace perinox::mechanics
