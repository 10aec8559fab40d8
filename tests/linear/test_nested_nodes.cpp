/// Grids of every second node: what they interpolate, what they keep apart, and the cycle over them.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "linear/coarse_solver.hpp"
#include "linear/nested_nodes.hpp"
#include "support/linear_problem.hpp"

namespace perinox::test {
namespace {

using Vector = std::vector<double>;

const char* const cut_through =
    "cracks: [{rectangle: {corner: [-1, -1, 6.01], edge1: [14, 0, 0], edge2: [0, 14, 0]}}]\n";

/// Nodes of the coarse grid of a cube of 12^3 particles with cells of 3^3, their matrix and the grid nested in them.
struct Nested {
  explicit Nested(const std::string& more)
      : deck(deck_of(held_cube(12, 0.33, more))),
        scene(mechanics::build_scene(deck, Communicator(MPI_COMM_SELF))),
        prescribed(static_cast<std::size_t>(scene.local()) * 3, 0),
        grid(scene.body(), prescribed, scene.families().damage, scene.bond_graph(), 3.0),
        matrix(linear::coarse_elasticity(scene, grid, scene.bond_graph(), 8, {})) {
    fine.id = grid.node_ids();
    for (std::size_t n = 0; n < fine.id.size(); ++n) {
      std::array<GlobalId, 3> place{};
      for (std::size_t a = 0; a < 3; ++a) place[a] = std::llround(grid.node_positions()[3 * n + a] / 3);
      fine.place.push_back(place);
    }
    const Communicator& alone = scene.body().communicator;
    nesting = linear::nest(alone, grid::SharedNodes(alone, fine.id), fine, matrix);
  }

  /// W c, component by component.
  Vector interpolated(const Vector& c) const {
    Vector f(3 * fine.id.size(), 0.0);
    for (std::size_t n = 0; n < fine.id.size(); ++n)
      for (std::size_t p = nesting.parent_begin[n]; p < nesting.parent_begin[n + 1]; ++p)
        for (std::size_t a = 0; a < 3; ++a)
          f[3 * n + a] += nesting.weight[p] * c[3 * static_cast<std::size_t>(nesting.parent[p]) + a];
    return f;
  }
  static double energy(const linear::CoarseMatrix& a, const Vector& u) {
    double sum = 0;
    for (std::size_t n = 0; n + 1 < a.row_begin.size(); ++n)
      for (std::size_t k = a.row_begin[n]; k < a.row_begin[n + 1]; ++k)
        for (std::size_t p = 0; p < 3; ++p)
          for (std::size_t q = 0; q < 3; ++q)
            sum += u[3 * n + p] * a.value[(k * 3 + p) * 3 + q] * u[3 * static_cast<std::size_t>(a.column[k]) + q];
    return sum;
  }

  deck::Deck deck;
  mechanics::Scene scene;
  std::vector<char> prescribed;
  grid::BackgroundGrid grid;
  linear::CoarseMatrix matrix;
  linear::GridNodes fine;
  linear::Nesting nesting;
};

TEST(NestedNodes, LinearFieldsAreInterpolatedExactly) {
  for (const char* more : {"", cut_through}) {
    const Nested nested(more);
    Vector c, expected;
    const auto field = [](const std::array<GlobalId, 3>& place, double scale, Vector& to) {
      const double x = scale * static_cast<double>(place[0]), y = scale * static_cast<double>(place[1]),
                   z = scale * static_cast<double>(place[2]);
      to.insert(to.end(), {1 + 2 * x - y, 3 * z - x, y + z - 2});
    };
    for (const auto& place : nested.nesting.coarse.place) field(place, 2, c);
    for (const auto& place : nested.fine.place) field(place, 1, expected);
    EXPECT_EQ(nested.interpolated(c), expected);  // whole numbers and halves: exact
  }
}

TEST(NestedNodes, CutBodiesShareNoNode) {
  EXPECT_EQ(Nested("").nesting.coarse.id.size(), 3 * 3 * 3U);
  const Nested cut(cut_through);
  // The cut goes through a plane of nodes of both grids; the planes on either side serve one half each.
  EXPECT_EQ(cut.fine.id.size(), 5 * 5 * 6U);
  EXPECT_EQ(cut.nesting.coarse.id.size(), 3 * 3 * 4U);
  // Whatever moves below does not move anything above.
  std::set<LocalIndex> below, above;
  for (const grid::GridElement& element : cut.grid.elements()) {
    const bool up = cut.scene.body().position(cut.grid.particle(element.begin))[2] > 6;
    for (const LocalIndex node : element.node)
      for (std::size_t p = cut.nesting.parent_begin[node]; p < cut.nesting.parent_begin[node + 1]; ++p)
        (up ? above : below).insert(cut.nesting.parent[p]);
  }
  EXPECT_EQ(below.size() + above.size(), cut.nesting.coarse.id.size());
  for (const LocalIndex node : below) EXPECT_EQ(above.count(node), 0U);
}

TEST(NestedNodes, GalerkinMatrixHasTheEnergyOfTheInterpolatedField) {
  for (const char* more : {"", cut_through}) {
    const Nested nested(more);
    const linear::CoarseMatrix coarse = linear::galerkin(nested.nesting, nested.matrix);
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> entry(-1, 1);
    Vector c(3 * nested.nesting.coarse.id.size());
    for (double& value : c) value = entry(generator);
    const double energy = Nested::energy(nested.matrix, nested.interpolated(c));
    EXPECT_NEAR(Nested::energy(coarse, c) / energy, 1, 1e-13);  // measured: 1e-15
  }
}

TEST(NestedNodes, CycleIsNearTheInverse) {
  // The error left by one cycle, in the norm of the matrix, from a random one; ten times over it falls each time.
  Nested nested("");
  for (std::size_t n = 0; n < nested.fine.id.size(); ++n)  // held a little everywhere, more at the foot
    for (int c = 0; c < 3; ++c) {
      double* block = nested.matrix.block(static_cast<LocalIndex>(n), static_cast<LocalIndex>(n));
      block[4 * c] *= nested.fine.place[n][2] == 0 ? 2 : 1 + 1e-6;
    }
  const auto cycle = linear::make_coarse_solver(nested.scene.body().communicator, nested.grid, nested.matrix, 2, 100);
  EXPECT_EQ(cycle->unknowns(), 375);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> entry(-1, 1);
  Vector error(3 * nested.fine.id.size()), correction(error.size());
  for (double& value : error) value = entry(generator);
  double before = Nested::energy(nested.matrix, error);
  for (int k = 0; k < 10; ++k) {
    Vector residual(error.size(), 0.0);
    const linear::CoarseMatrix& a = nested.matrix;
    for (std::size_t n = 0; n + 1 < a.row_begin.size(); ++n)
      for (std::size_t b = a.row_begin[n]; b < a.row_begin[n + 1]; ++b)
        for (std::size_t p = 0; p < 3; ++p)
          for (std::size_t q = 0; q < 3; ++q)
            residual[3 * n + p] += a.value[(b * 3 + p) * 3 + q] * error[3 * static_cast<std::size_t>(a.column[b]) + q];
    cycle->solve(residual.data(), correction.data());
    for (std::size_t u = 0; u < error.size(); ++u) error[u] -= correction[u];
    const double after = Nested::energy(nested.matrix, error);
    std::printf("cycle %d leaves %.3f of the error\n", k, std::sqrt(after / before));
    EXPECT_LT(after, 0.25 * before);
    before = after;
  }
}

}  // namespace
}  // namespace perinox::test
