#pragma once
#include <vector>

#include "perinox/grid/background_grid.hpp"
#include "perinox/medium/model.hpp"

namespace perinox::linear {

/// A symmetric matrix of dimension x dimension blocks over the coarse nodes of one rank: this rank's share, which adds
/// up over the ranks.
struct CoarseMatrix {
  int dimension = 3;
  std::vector<std::size_t> row_begin;  ///< [nodes + 1]
  std::vector<LocalIndex> column;      ///< ascending within a row; local coarse nodes
  std::vector<double> value;           ///< [blocks * dimension^2], blocks row-major

  /// The block at (row, column), which must be in the pattern.
  double* block(LocalIndex row, LocalIndex column_node);
};

/// Local linear elasticity on the coarse grid,
///     a(u, v) = int kappa div u div v + 2 mu dev e(u) : dev e(v),
/// with d-linear elements, integrated over the particles: each stands for a cube of its volume with its moduli, so that
/// a cell which a crack, a surface or a hole cuts counts what is there of it. Where materials meet, a particle counts
/// with the mean over its family: the bonds of stiff particles stiffen a layer of soft ones as thick as the horizon.
/// kappa counts up to bulk_limit mu: beyond it the coarse solve loses its quality, and the fine level's nonlocal
/// dilatation is not that stiff anyway.
/// shear_left: factor of every particle's mu, [owned]; empty: 1.
CoarseMatrix coarse_elasticity(const medium::Model& model, const grid::BackgroundGrid& grid,
                               const bonds::BondGraph& graph, double bulk_limit, const std::vector<double>& shear_left);

/// Adds springs to the ground at particles: c -> sum_u stiffness_u (P c)_u^2, P without its zeros on prescribed
/// unknowns. stiffness: [owned * dimension], zero where there is none.
void add_springs(const medium::Model& model, const grid::BackgroundGrid& grid, const std::vector<double>& stiffness,
                 CoarseMatrix& matrix);

}  // namespace perinox::linear
