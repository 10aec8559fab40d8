/// The whole tangent, for every material, state, influence function and quadrature: it is the derivative of the
/// internal force, it is symmetric, and its diagonal blocks are its diagonal blocks.
#include <gtest/gtest.h>

#include <tuple>

#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

struct Case {
  MaterialRow row;
  LoadState state;
  friend void PrintTo(const Case& one, std::ostream* stream) { *stream << one.row.name << ' ' << one.state.name; }
};

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const MaterialRow& row : material_table())
    for (const LoadState& state : load_states())
      if (!state.needs_plasticity || !row.surface.empty()) list.push_back({row, state});
  return list;
}

class WholeTangent : public ::testing::TestWithParam<std::tuple<Case, deck::Influence, deck::Quadrature>> {
 protected:
  const Case& one() const { return std::get<0>(GetParam()); }
  WholeTangent()
      : scene_(small_scene(one().row, std::get<1>(GetParam()), std::get<2>(GetParam()))),
        fields_(fields_of(scene_, one().state)),
        committed_(committed_after(scene_, {fields_.begin(), fields_.end() - 1})),
        tangent_(scene_) {
    tangent_.linearise(committed_, fields_.back().data(), deck::TangentForm::consistent);
  }

  mechanics::Scene scene_;
  std::vector<Vector> fields_;
  mechanics::Committed committed_;
  mechanics::MatrixFreeTangent tangent_;
};

TEST_P(WholeTangent, StateIsWhatItsNameSays) {
  const long long yielding = internal_force(scene_, committed_, fields_.back()).trial.yielding;
  if (one().row.surface.empty() || one().state.flow == Flow::none) {
    EXPECT_EQ(yielding, 0);
  } else if (one().state.flow == Flow::all) {
    EXPECT_EQ(yielding, scene_.owned());
  } else {
    EXPECT_GT(yielding, scene_.owned() / 8);
    EXPECT_LT(yielding, scene_.owned() - scene_.owned() / 8);
  }
}

TEST_P(WholeTangent, IsTheDerivativeOfTheInternalForce) {
  const double error = tangent_error(scene_, committed_, fields_.back(), random_field(scene_, 1, 11), tangent_);
  EXPECT_LE(measured("tangent against central differences, " + one().state.name, error), 1e-8);  // 8.0e-10
}

TEST_P(WholeTangent, IsSymmetric) {
  EXPECT_LE(
      measured("tangent: asymmetry", asymmetry(tangent_, random_field(scene_, 1, 12), random_field(scene_, 1, 13))),
      1e-14);  // 1.7e-16
}

TEST_P(WholeTangent, DiagonalBlocksAreItsDiagonalBlocks) {
  if (!scene_.families().moments.empty())
    GTEST_SKIP() << "a fitted family's share in its neighbours' blocks is an approximation: see TwoLevel.PositionAware";
  const int d = scene_.dimension();
  Vector blocks(scene_.owned_unknowns() * static_cast<std::size_t>(d), std::nan(""));
  tangent_.diagonal_blocks(blocks.data());
  double worst = 0;
  for (LocalIndex i = 0; i < scene_.owned(); i += 7)  // corner, edge, face and inside points are all among these
    for (int c = 0; c < d; ++c) {
      Vector unit(scene_.owned_unknowns(), 0.0);
      unit[i * d + c] = 1;
      const Vector column = times(tangent_, unit);
      for (int row = 0; row < d; ++row)
        worst =
            std::max(worst, std::abs(blocks[(i * d + row) * d + c] - column[i * d + row]) / largest_magnitude(column));
    }
  EXPECT_LE(measured("tangent: diagonal blocks against columns", worst), 1e-13);  // 9.1e-16
}

INSTANTIATE_TEST_SUITE_P(Scenes, WholeTangent,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values(deck::Influence::constant, deck::Influence::inverse,
                                                              deck::Influence::polynomial),
                                            ::testing::Values(deck::Quadrature::whole, deck::Quadrature::partial_volume,
                                                              deck::Quadrature::taper_inside,
                                                              deck::Quadrature::position_aware)),
                         [](const auto& one) {
                           return std::get<0>(one.param).row.name + "_" + std::get<0>(one.param).state.name + "_" +
                                  name_of(std::get<1>(one.param)) + "_" + name_of(std::get<2>(one.param));
                         });

}  // namespace
}  // namespace perinox::test
