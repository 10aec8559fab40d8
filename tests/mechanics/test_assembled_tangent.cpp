/// One operator, two forms: the sparse matrix and the matrix-free product come from the same D, p, q and agree to
/// rounding, prescribed unknowns included; the program's own tangent check sees a right tangent as right and the
/// printed one as wrong.
#include <gtest/gtest.h>

#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Vector.hpp>

#include "mechanics/assembled_tangent.hpp"
#include "perinox/mechanics/tangent_check.hpp"
#include "support/load_states.hpp"
#include "support/measured.hpp"

namespace perinox::test {
namespace {

Vector times_matrix(const mechanics::AssembledTangent& assembled, const Vector& x) {
  const auto map = assembled.matrix()->getDomainMap();
  tpetra::Vector in(map), out(map);
  {
    const auto values = in.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t u = 0; u < x.size(); ++u) values(u, 0) = x[u];
  }
  assembled.matrix()->apply(in, out);
  const auto values = out.getLocalViewHost(Tpetra::Access::ReadOnly);
  Vector y(x.size());
  for (std::size_t u = 0; u < x.size(); ++u) y[u] = values(u, 0);
  return y;
}

TEST(AssembledTangent, AgreesWithTheMatrixFreeProduct) {
  for (const MaterialRow& row : material_table())
    for (const LoadState& state : load_states())
      for (deck::TangentForm form : {deck::TangentForm::consistent, deck::TangentForm::printed}) {
        if (state.needs_plasticity && row.surface.empty()) continue;
        SCOPED_TRACE(row.name + " " + state.name);
        const mechanics::Scene scene = small_scene(row, deck::Influence::polynomial, deck::Quadrature::partial_volume);
        std::vector<Vector> fields = fields_of(scene, state);
        const Vector here = fields.back();
        fields.pop_back();
        const mechanics::Committed committed = committed_after(scene, fields);
        mechanics::StoredTangent tangent(scene);
        tangent.linearise(committed, here.data(), form);
        const auto operator_of_the_form = mechanics::make_tangent(scene, form);
        operator_of_the_form->linearise(committed, here.data(), form);
        mechanics::AssembledTangent assembled(scene, std::vector<char>(scene.local_unknowns(), 0));
        assembled.fill(tangent, 1);
        const Vector x = random_field(scene, 1, 51);
        const Vector product = times(*operator_of_the_form, x);
        EXPECT_LE(measured("assembled against matrix-free", relative_difference(times_matrix(assembled, x), product)),
                  1e-13);  // 8.5e-16
        // A second fill forgets the first.
        assembled.fill(tangent, 1);
        EXPECT_LE(relative_difference(times_matrix(assembled, x), product), 1e-13);
      }
}

TEST(AssembledTangent, PrescribedUnknownsAreADiagonal) {
  const mechanics::Scene scene = small_scene(material_table()[0], deck::Influence::constant, deck::Quadrature::whole);
  mechanics::StoredTangent tangent(scene);
  tangent.linearise(mechanics::Committed(scene), field_of(scene, {1.0}).data(), deck::TangentForm::consistent);
  std::vector<char> prescribed(scene.local_unknowns(), 0);
  for (std::size_t u = 0; u < prescribed.size(); u += 5) prescribed[u] = 1;
  const double diagonal = 3e4;  // any number
  mechanics::AssembledTangent assembled(scene, prescribed);
  assembled.fill(tangent, diagonal);
  const Vector x = random_field(scene, 1, 52);
  Vector free = x;
  for (std::size_t u = 0; u < x.size(); ++u)
    if (prescribed[u]) free[u] = 0;
  Vector expected = times(tangent, free);
  for (std::size_t u = 0; u < x.size(); ++u)
    if (prescribed[u]) expected[u] = diagonal * x[u];
  EXPECT_LE(measured("assembled with prescribed unknowns", relative_difference(times_matrix(assembled, x), expected)),
            1e-13);  // 5.6e-16
}

TEST(TangentCheck, TellsTheConsistentFromThePrintedForm) {
  const MaterialRow row = material_table()[4];
  ASSERT_EQ(row.name, "plastic_perfect");
  const mechanics::Scene scene = small_scene(row, deck::Influence::constant, deck::Quadrature::whole);
  const mechanics::Committed start(scene);
  const Vector field = field_of(scene, {4.0});
  const mechanics::TangentCheck right =
      mechanics::check_tangent(scene, start, field, deck::TangentForm::consistent, true);
  EXPECT_EQ(right.yielding, scene.owned());
  EXPECT_LE(measured("check_tangent: consistent", right.direction), 1e-8);  // 2.3e-11
  EXPECT_LE(measured("check_tangent: symmetry", right.symmetry), 1e-14);    // 3.4e-17
  EXPECT_GE(right.assembled, 0);
  EXPECT_LE(measured("check_tangent: assembled", right.assembled), 1e-14);  // 5.0e-16
  ASSERT_EQ(right.of_material.size(), 1u);
  EXPECT_NEAR(right.of_material[0], right.direction, 1e-3 * right.direction);
  const mechanics::TangentCheck wrong =
      mechanics::check_tangent(scene, start, field, deck::TangentForm::printed, false);
  EXPECT_GT(wrong.direction, 0.1);
  EXPECT_EQ(wrong.assembled, -1);
}

}  // namespace
}  // namespace perinox::test
