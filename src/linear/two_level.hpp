#pragma once
#include <memory>

#include "block_jacobi.hpp"
#include "coarse_solver.hpp"
#include "perinox/core/saved_state.hpp"

namespace perinox::linear {

/// The additive two-level preconditioner of the tangent,
///     z = D^-1 r + w P A_c^-1 P^T r,
/// D: diagonal blocks of the current tangent; P: BackgroundGrid; A_c: coarse_elasticity. Peridynamic spectra are flat
/// below the horizon, where D does, and local above it, where a grid of cells of about a horizon does: iterations do
/// not grow with the body. Symmetric and positive definite by construction.
class TwoLevel : public OwnedOperator {
 public:
  struct Settings {
    double cell = 1;                    ///< largest edge of the grid's cells over the horizon; two spacings at least
    double finer_cell = 0.67;           ///< the same where finer_cells_pay()
    double bulk_limit = 8;              ///< see coarse_elasticity
    double spring = 1;                  ///< scale of the springs that stand for prescribed unknowns
    double softening = 0.1;             ///< mean change of shear_left at which A_c is made anew
    double weight = 1;                  ///< of the coarse term, where nothing flows
    int smoothing = 3;                  ///< degree of the V-cycle's Chebyshev smoothers
    long long factorised_up_to = 2500;  ///< coarse unknowns up to which they are factorised
  };

  /// False for a body of two cells at most on every axis: D alone does as well there. Collective.
  static bool worth_its_cost(const medium::Model& model);

  /// What of the tangent's stiffness against dilatation belongs in the diagonal blocks given to set(). Collective.
  static double dilatation_share(const medium::Model& model);

  /// prescribed: [local * dimension], ghosts up to date; kept by reference, as is the model. Collective.
  TwoLevel(Teuchos::RCP<const tpetra::Map> map, const medium::Model& model, const std::vector<char>& prescribed,
           const bonds::BondGraph& graph, const Settings& settings);

  /// Takes the tangent's diagonal blocks [owned * dimension^2], row-major, with `diagonal` on prescribed unknowns, and
  /// Tangent::shear_left. The first call also makes A_c, of moduli, geometry, cracks and supports; later ones make it
  /// anew when the shear moduli have changed by Settings::softening in the mean over the body. True if it made A_c.
  /// Collective.
  bool set(const std::vector<double>& blocks, double diagonal, const std::vector<double>& shear_left = {});
  void multiply(const double* x, double* y) const override;

  /// What A_c was made of, and A_c made of it again. Nothing where it has not been made. Collective.
  void save(StateWriter& writer) const;
  void restore(StateReader& reader);

  const grid::BackgroundGrid& grid() const { return grid_; }
  const BlockJacobi& block_jacobi() const { return block_jacobi_; }
  /// Null before the first set().
  CoarseSolver* coarse_solver() const { return solver_.get(); }
  /// Seconds the last multiply() spent in P and P^T, and in the coarse solve.
  double transfer_seconds() const { return transfer_seconds_; }
  double solve_seconds() const { return solve_seconds_; }

 private:
  bool softened(const std::vector<double>& shear_left) const;
  std::vector<double> springs(const std::vector<double>& blocks) const;
  /// Makes A_c of springs_ and shear_left_.
  void make_coarse();

  const medium::Model& model_;
  const std::vector<char>& prescribed_;
  bonds::BondGraph graph_;          ///< until A_c is first made
  std::vector<double> shear_left_;  ///< of A_c
  std::vector<double> springs_;     ///< of A_c, [owned * dimension]
  double weight_ = 1;               ///< of the coarse term: Settings::weight and the mean share of mu that flow took
  long long bonds_broken_ = 0;      ///< when A_c was made, over all ranks
  Settings settings_;
  BlockJacobi block_jacobi_;
  grid::BackgroundGrid grid_;
  std::unique_ptr<CoarseSolver> solver_;
  mutable std::vector<double> right_, solution_;
  mutable double transfer_seconds_ = 0, solve_seconds_ = 0;
};

}  // namespace perinox::linear
