/// A scene holds what it needs and nothing else, counted in bytes: no plastic history where no block is plastic, no
/// geometric term under small strain, plastic extension only where something has flowed, and `perinox check` foretells
/// all of it.
#include <gtest/gtest.h>

#include "perinox/mechanics/family_loops.hpp"
#include "support/load_states.hpp"

namespace perinox::test {
namespace {

mechanics::Scene block(const MaterialRow& row, bool small, mechanics::Layout layout, int edge = 12,
                       deck::Quadrature quadrature = deck::Quadrature::whole) {
  deck::Deck deck = lattice_deck(deck::Dimension::three, {edge, edge, edge}, 0.4, 3.015);
  deck.small_strain = small;
  deck.quadrature = quadrature;
  return make_scene(deck, materials_of(row.make()), layout);
}
const MaterialRow& row_named(const std::string& name) {
  static const std::vector<MaterialRow> rows = material_table();
  for (const MaterialRow& row : rows)
    if (row.name == name) return row;
  throw std::logic_error("no such material row");
}
const MaterialRow& elastic() { return row_named("elastic"); }
const MaterialRow& plastic() {
  static const std::vector<MaterialRow> rows = material_table();
  for (const MaterialRow& row : rows)
    if (!row.surface.empty()) return row;
  throw std::logic_error("no plastic row");
}

/// Bytes of a loops object that has linearised and multiplied once at `strain` yield strains.
std::size_t tangent_bytes(const mechanics::Scene& scene, double strain) {
  mechanics::MatrixFreeTangent tangent(scene);
  const mechanics::Committed committed(scene);
  tangent.linearise(committed, field_of(scene, {strain}).data(), deck::TangentForm::consistent);
  times(tangent, random_field(scene, 1, 3));
  std::size_t values = tangent.shear_left().empty() ? 5 : 6;  // a particle, besides the loops
  if (mechanics::has_back_stress(scene)) ++values;
  const std::size_t fits = scene.families().moments.size() * (2 * sizeof(bonds::Mandel) + sizeof(double[36]));
  return tangent.bytes() - values * static_cast<std::size_t>(scene.owned()) * sizeof(double) - fits;
}

TEST(Memory, IsWhatCheckForetells) {
  for (const mechanics::Layout layout : {mechanics::Layout::automatic, mechanics::Layout::pairs})
    for (const bool small : {false, true})
      for (const auto& [row, quadrature] :
           {std::pair(&elastic(), deck::Quadrature::whole), std::pair(&plastic(), deck::Quadrature::whole),
            std::pair(&row_named("plastic_combined"), deck::Quadrature::whole),
            std::pair(&elastic(), deck::Quadrature::position_aware),
            std::pair(&plastic(), deck::Quadrature::position_aware)}) {
        SCOPED_TRACE(row->name);
        const mechanics::Scene scene = block(*row, small, layout, 12, quadrature);
        const mechanics::LoopMemory expected = mechanics::FamilyLoops::make(scene)->expected();
        const double slack = 1.02 * static_cast<double>(expected.tangent);  // the pointers of a first flow and the like
        const auto held = static_cast<double>(tangent_bytes(scene, row->surface.empty() ? 0.1 : 4));
        EXPECT_LE(held, slack);
        EXPECT_GE(held, 0.9 * static_cast<double>(expected.tangent));
      }
}

TEST(Memory, ElasticScenesCarryNoPlasticHistory) {
  const mechanics::Scene scene = block(elastic(), false, mechanics::Layout::automatic);
  EXPECT_EQ(scene.point_history().back(), 0);
  EXPECT_EQ(mechanics::FamilyLoops::make(scene)->expected().plastic, 0U);
  const mechanics::Committed committed = committed_after(scene, {field_of(scene, {5.0})});
  EXPECT_EQ(committed.plastic().bytes(), 0U);
  EXPECT_TRUE(internal_force(scene, committed, field_of(scene, {6.0})).trial.flow.empty());
}

TEST(Memory, PlasticExtensionOnlyWhereSomethingHasFlowed) {
  const mechanics::Scene scene = block(plastic(), false, mechanics::Layout::automatic);
  const std::size_t most = mechanics::FamilyLoops::make(scene)->expected().plastic;
  EXPECT_EQ(committed_after(scene, {field_of(scene, {0.1})}).plastic().bytes(), 0U);
  const std::size_t some = committed_after(scene, {field_of(scene, {0.5, 0, true})}).plastic().bytes();
  EXPECT_GT(some, 0U);
  EXPECT_LT(some, most);
  EXPECT_LE(committed_after(scene, {field_of(scene, {4.0})}).plastic().bytes(), most);
}

TEST(Memory, SmallStrainHasNoGeometricTerm) {
  const mechanics::Scene finite = block(elastic(), false, mechanics::Layout::automatic);
  const mechanics::Scene small = block(elastic(), true, mechanics::Layout::automatic);
  // Three arrays of the displacement and one of the radial force state less; an array is at least a double a cell.
  const std::size_t cells = static_cast<std::size_t>(finite.lattice()->grid().size());
  EXPECT_GE(tangent_bytes(finite, 0.1) - tangent_bytes(small, 0.1), 4 * cells * sizeof(double));
}

TEST(Memory, ABondCostsNextToNothing) {
  const mechanics::Scene scene = block(plastic(), false, mechanics::Layout::automatic, 32);
  const auto particles = static_cast<double>(scene.owned());
  const mechanics::LoopMemory memory = mechanics::FamilyLoops::make(scene)->expected();
  EXPECT_LE(static_cast<double>(scene.lattice()->bytes()) / particles, 32);             // 21
  EXPECT_LE(static_cast<double>(memory.evaluation + memory.tangent) / particles, 450);  // 330
  EXPECT_LE(static_cast<double>(memory.plastic) / particles, 1300);                     // 1150
}

}  // namespace
}  // namespace perinox::test
