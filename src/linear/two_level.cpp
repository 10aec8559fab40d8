#include "two_level.hpp"

#include <algorithm>
#include <cmath>

#include "perinox/core/clock.hpp"
#include "perinox/linear/coarse_spacing.hpp"

namespace perinox::linear {

namespace {

/// Every coarse node is tied to the ground by this share of its own stiffness, so that a coarse piece that nothing
/// holds (a flake cut out of the body) leaves the matrix definite.
constexpr double grounding = 1e-10;
/// Least share of a prescribed particle's stiffness that holds the coarse grid: nodes deep inside a support would float
/// without it.
constexpr double least_spring = 0.1;

/// Below two spacings a cell would have about as many unknowns as its particles.
double cell_edge(const medium::Model& model, const TwoLevel::Settings& settings) {
  const double over_horizon = finer_cells_pay(model) ? settings.finer_cell : settings.cell;
  const body::Body& body = model.body();
  double volume = 0;
  for (LocalIndex i = 0; i < body.owned; ++i) volume += body.volume[i];
  const double spacing =
      std::pow(body.communicator.sum(volume) / static_cast<double>(body.total), 1.0 / body.dimension);
  return std::max(over_horizon * model.horizon(), 2 * spacing);
}

}  // namespace

bool TwoLevel::worth_its_cost(const medium::Model& model) {
  const grid::Cells cells(model.body(), cell_edge(model, Settings()));
  return *std::max_element(cells.counts().begin(), cells.counts().end()) > 2;
}

double TwoLevel::dilatation_share(const medium::Model& model) {
  // Most fields that D has to deal with change no volume: with all of the dilatation it is too stiff for them. The best
  // shares found are 0.5 for kappa/mu = 50 (nu = 0.49) and 0.1 for 500 (0.499).
  return std::min(1.0, std::pow(18 / largest_bulk_over_shear(model), 0.7));
}

TwoLevel::TwoLevel(Teuchos::RCP<const tpetra::Map> map, const medium::Model& model, const std::vector<char>& prescribed,
                   const bonds::BondGraph& graph, const Settings& settings)
    : OwnedOperator(map),
      model_(model),
      prescribed_(prescribed),
      graph_(graph),
      settings_(settings),
      block_jacobi_(map, model.dimension(), prescribed),
      grid_(model.body(), prescribed, *model.local_elasticity()->damage, graph, cell_edge(model, settings)),
      right_(grid_.unknowns()),
      solution_(grid_.unknowns()) {}

/// Collective, as every rank has to make A_c anew or none.
bool TwoLevel::softened(const std::vector<double>& shear_left) const {
  const body::Body& body = model_.body();
  std::vector<double> sums{0, 0};
  for (LocalIndex i = 0; i < body.owned; ++i) {
    const double left = shear_left.empty() ? 1 : shear_left[i], built = shear_left_.empty() ? 1 : shear_left_[i];
    sums[0] += body.volume[i] * std::abs(left - built);
    sums[1] += body.volume[i];
  }
  body.communicator.sum(sums);
  return sums[0] > settings_.softening * sums[1];
}

std::vector<double> TwoLevel::springs(const std::vector<double>& blocks) const {
  // A function that is constant c but zero on prescribed unknowns has the energy c^2/2 times the stiffness of all bonds
  // between prescribed and free particles: what a smooth field on the grid does not know of. It goes to the prescribed
  // ends, each with its own diagonal stiffness times the share of its neighbours that are free.
  const auto d = static_cast<std::size_t>(model_.dimension());
  std::vector<double> stiffness(model_.owned_unknowns(), 0.0);
  std::vector<LocalIndex> neighbors;
  for (LocalIndex i = 0; i < model_.owned(); ++i) {
    const std::size_t first = static_cast<std::size_t>(i) * d;
    if (std::none_of(&prescribed_[first], &prescribed_[first] + d, [](char held) { return held != 0; })) continue;
    graph_(i, neighbors);
    for (std::size_t c = 0; c < d; ++c) {
      if (!prescribed_[first + c]) continue;
      double free = 0;
      for (const LocalIndex j : neighbors) free += prescribed_[static_cast<std::size_t>(j) * d + c] ? 0 : 1;
      const double share = free / static_cast<double>(std::max<std::size_t>(1, neighbors.size()));
      stiffness[first + c] = settings_.spring * std::max(share, least_spring) * std::abs(blocks[(first + c) * d + c]);
    }
  }
  return stiffness;
}

bool TwoLevel::set(const std::vector<double>& blocks, double diagonal, const std::vector<double>& shear_left) {
  block_jacobi_.set(blocks, diagonal);
  if (solver_ && !softened(shear_left)) return false;
  shear_left_ = shear_left;
  if (!graph_) graph_ = model_.bond_graph();
  springs_ = springs(blocks);
  make_coarse();
  return true;
}

void TwoLevel::save(StateWriter& writer) const {
  if (!solver_) return;
  const std::vector<double> all(static_cast<std::size_t>(model_.owned()), 1.0);
  writer.particles("tangent/coarse_springs", springs_.data(), model_.dimension());
  writer.particles("tangent/coarse_shear_left", shear_left_.empty() ? all.data() : shear_left_.data(), 1);
  writer.integer("tangent/coarse_bonds_broken", bonds_broken_);
}

void TwoLevel::restore(StateReader& reader) {
  if (!reader.has("tangent/coarse_springs")) return;
  springs_ = reader.particles("tangent/coarse_springs", model_.dimension());
  shear_left_ = reader.particles("tangent/coarse_shear_left", 1);
  make_coarse();
}

void TwoLevel::make_coarse() {
  if (!graph_) graph_ = model_.bond_graph();
  bonds_broken_ = model_.body().communicator.sum(model_.bonds_gone());
  CoarseMatrix matrix = coarse_elasticity(model_, grid_, graph_, settings_.bulk_limit, shear_left_);
  add_springs(model_, grid_, springs_, matrix);
  for (std::size_t n = 0; n < grid_.node_ids().size(); ++n) {
    double* block = matrix.block(static_cast<LocalIndex>(n), static_cast<LocalIndex>(n));
    for (int c = 0; c < matrix.dimension; ++c) block[c * (matrix.dimension + 1)] *= 1 + grounding;
  }
  solver_ = make_coarse_solver(model_.body().communicator, grid_, std::move(matrix), settings_.smoothing,
                               settings_.factorised_up_to);
  // Flow leaves a body soft in bands and along one direction at a point: a cycle, whose levels take the mean over ever
  // larger cells, solves for too little.
  double lost = 0, volume = 0;
  for (LocalIndex i = 0; i < model_.owned(); ++i) {
    lost += shear_left_.empty() ? 0 : model_.body().volume[i] * (1 - shear_left_[i]);
    volume += model_.body().volume[i];
  }
  std::vector<double> sums{lost, volume};
  model_.body().communicator.sum(sums);
  weight_ = settings_.weight * (solver_->exact() ? 1 : 1 + sums[0] / sums[1]);
  graph_ = nullptr;  // may hold a word a bond
}

void TwoLevel::multiply(const double* x, double* y) const {
  block_jacobi_.multiply(x, y);
  const double start = now();
  grid_.restrict_to_nodes(x, right_.data());
  const double restricted = now();
  solver_->solve(right_.data(), solution_.data());
  for (double& value : solution_) value *= weight_;
  const double solved = now();
  grid_.add_interpolated(solution_.data(), y);
  solve_seconds_ = solved - restricted;
  transfer_seconds_ = restricted - start + now() - solved;
}

}  // namespace perinox::linear
