/// Tests what a deck's text becomes.
#include <filesystem>
#include <fstream>

#include "deck/fixture.hpp"
#include "perinox/deck/restart.hpp"

namespace perinox::deck {
namespace {

Deck read_base(const std::vector<std::string>& overrides = {}) {
  return read_text(fixture::base_deck, "deck.yaml", fixture::schema(), overrides);
}

TEST(Read, FillsEveryPartOfTheDeck) {
  const Deck deck = read_base();
  EXPECT_EQ(deck.title, "base");
  EXPECT_EQ(deck.file, "deck.yaml");
  EXPECT_EQ(deck.dimension, Dimension::three);
  ASSERT_EQ(deck.body.size(), 1u);
  EXPECT_EQ(deck.body[0].name, "block");
  EXPECT_EQ(deck.body[0].spacing, 1.0);
  EXPECT_EQ(deck.body[0].material, "steel");
  EXPECT_EQ(deck.body[0].location.text(), "deck.yaml:4:5");
  EXPECT_EQ(std::get<Box>(deck.body[0].shape.form).max, (Point{4, 4, 8}));
  EXPECT_EQ(deck.body[0].shape.location.text(), "deck.yaml:5:12");
  EXPECT_EQ(deck.horizon.ratio, 3.015);
  EXPECT_FALSE(deck.horizon.length.has_value());
  ASSERT_EQ(deck.materials.size(), 1u);
  EXPECT_EQ(deck.materials[0].name, "steel");
  EXPECT_EQ(deck.materials[0].model, "elastic-plastic");
  ASSERT_EQ(deck.sets.size(), 2u);
  EXPECT_TRUE(std::get<SetWhere>(deck.sets[0].form).condition.holds(0, 0, 1));
  EXPECT_FALSE(std::get<SetWhere>(deck.sets[0].form).condition.holds(0, 0, 2));
  ASSERT_EQ(deck.boundary.size(), 2u);
  EXPECT_EQ(deck.boundary[1].set, "head");
  EXPECT_EQ(deck.boundary[1].kind, LoadKind::displacement);
  EXPECT_FALSE(deck.boundary[1].component[0].has_value());
  ASSERT_TRUE(deck.boundary[1].component[2].has_value());
  EXPECT_DOUBLE_EQ((*deck.boundary[1].component[2])(0, 0, 0, 2), 0.6);
  EXPECT_EQ(deck.steps.count, 20);
  EXPECT_EQ(deck.output.fields, (std::vector<std::string>{"displacement", "force"}));
  ASSERT_EQ(deck.history.size(), 1u);
  EXPECT_EQ(deck.history[0].kind, HistoryKind::reaction);
  EXPECT_EQ(deck.history[0].component, 2);
}

TEST(Read, MaterialParametersCarryDefaultsAndAbsence) {
  const Value parameters = read_base().materials[0].parameters;
  EXPECT_EQ(parameters.at("bulk_modulus").number(), 160e3);
  EXPECT_EQ(parameters.at("bulk_modulus").location().text(), "deck.yaml:14:19");
  EXPECT_TRUE(parameters.at("bulk_modulus").given());
  EXPECT_FALSE(parameters.has("young_modulus"));
  EXPECT_FALSE(parameters.has("density"));
  EXPECT_FALSE(parameters.has("hardening_modulus"));
  EXPECT_TRUE(parameters.at("dilatation").boolean());
  EXPECT_FALSE(parameters.at("dilatation").given());
  EXPECT_EQ(parameters.at("yield_scaling").text(), "discrete");
  EXPECT_EQ(parameters.at("yield_stress").at("tension").number(), 203.1);
  EXPECT_FALSE(parameters.at("yield_stress").has("shear"));
}

/// The defaults written in the schema and those of the plain structs must be the same.
TEST(Read, DefaultsOfSchemaAndStructsAgree) {
  const Deck deck = read_text(
      "dimension: 3\n"
      "body: [{name: b, shape: {sphere: {center: [0, 0, 0], radius: 1}}, spacing: 0.1, material: m}]\n"
      "horizon: {ratio: 3}\n"
      "materials: {m: {model: elastic}}\n",
      "folder/small.yaml", fixture::schema());
  EXPECT_EQ(deck.title, "small");
  EXPECT_EQ(deck.bond_bodies, Deck().bond_bodies);
  EXPECT_EQ(deck.influence, Influence::constant);
  EXPECT_EQ(deck.quadrature, Deck().quadrature);
  EXPECT_EQ(deck.quadrature, Quadrature::position_aware);
  EXPECT_EQ(deck.steps.end, Steps().end);
  EXPECT_EQ(deck.steps.count, Steps().count);
  EXPECT_EQ(deck.steps.adaptive, Steps().adaptive);
  EXPECT_EQ(deck.steps.max_cuts, Steps().max_cuts);
  EXPECT_EQ(deck.solver.tangent, Solver().tangent);
  EXPECT_EQ(deck.solver.form, Solver().form);
  EXPECT_EQ(deck.solver.newton.tolerance, Newton().tolerance);
  EXPECT_EQ(deck.solver.newton.update_tolerance, Newton().update_tolerance);
  EXPECT_EQ(deck.solver.newton.max_iterations, Newton().max_iterations);
  EXPECT_EQ(deck.solver.newton.line_search, Newton().line_search);
  EXPECT_EQ(deck.solver.newton.forcing, Newton().forcing);
  EXPECT_EQ(deck.solver.linear.method, Linear().method);
  EXPECT_EQ(deck.solver.linear.preconditioner, Linear().preconditioner);
  EXPECT_EQ(deck.solver.linear.tolerance, Linear().tolerance);
  EXPECT_EQ(deck.solver.linear.max_iterations, Linear().max_iterations);
  EXPECT_EQ(deck.output.every, Output().every);
  EXPECT_TRUE(deck.sets.empty() && deck.boundary.empty() && deck.history.empty() && deck.cracks.empty());
}

TEST(Read, EveryWordReachesItsEnumeration) {
  const auto with = [](const std::string& assignment) { return read_base({assignment}); };
  EXPECT_EQ(with("influence=inverse").influence, Influence::inverse);
  EXPECT_EQ(with("influence=polynomial").influence, Influence::polynomial);
  EXPECT_EQ(with("quadrature=partial-volume").quadrature, Quadrature::partial_volume);
  EXPECT_EQ(with("quadrature=taper-inside").quadrature, Quadrature::taper_inside);
  EXPECT_EQ(with("solver.tangent=assembled").solver.tangent, TangentKind::assembled);
  EXPECT_EQ(with("solver.form=printed").solver.form, TangentForm::printed);
  EXPECT_EQ(with("solver.newton.line_search=full-step").solver.newton.line_search, LineSearch::full_step);
  EXPECT_EQ(with("solver.newton.forcing=constant").solver.newton.forcing, Forcing::constant);
  EXPECT_EQ(with("solver.tangent=matrix-free").solver.tangent, TangentKind::matrix_free);
  EXPECT_EQ(with("solver.tangent=auto").solver.tangent, TangentKind::automatic);
  EXPECT_EQ(with("solver.linear.method=cg").solver.linear.method, LinearMethod::cg);
  EXPECT_EQ(with("solver.linear.method=gmres").solver.linear.method, LinearMethod::gmres);
  const std::vector<std::pair<std::string, Preconditioner>> preconditioners{
      {"automatic", Preconditioner::automatic}, {"none", Preconditioner::none},
      {"two-level", Preconditioner::two_level}, {"block-jacobi", Preconditioner::block_jacobi},
      {"jacobi", Preconditioner::jacobi},       {"symmetric-gauss-seidel", Preconditioner::symmetric_gauss_seidel},
      {"chebyshev", Preconditioner::chebyshev}, {"ilu", Preconditioner::ilu}};
  for (const auto& [word, value] : preconditioners) {
    const Deck deck = read_base({"solver.tangent=assembled", "solver.linear.preconditioner=" + word});
    EXPECT_EQ(deck.solver.linear.preconditioner, value) << word;
  }
}

TEST(Read, TheTangentIsAssembledOnlyWhereItMustBe) {
  const auto assembled = [](std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), "solver.tangent=auto");
    return read_base(overrides).solver.assembled();
  };
  for (const char* word : {"automatic", "none", "block-jacobi"})
    EXPECT_FALSE(assembled({std::string("solver.linear.preconditioner=") + word})) << word;
  for (const char* word : {"jacobi", "symmetric-gauss-seidel", "chebyshev", "ilu"})
    EXPECT_TRUE(assembled({std::string("solver.linear.preconditioner=") + word})) << word;
  EXPECT_TRUE(assembled({"solver.linear.method=direct"}));
  EXPECT_FALSE(assembled({"solver.linear.method=gmres"}));
  EXPECT_TRUE(assembled({"solver.tangent=assembled"}));
  EXPECT_EQ(read_base({"solver.tangent=auto", "solver.linear.method=direct"}).solver.linear.method,
            LinearMethod::direct);
}

TEST(Read, PlaneDecks) {
  const Deck deck = read_text(fixture::flat_deck, "deck.yaml", fixture::schema());
  EXPECT_EQ(deck.dimension, Dimension::plane_strain);
  EXPECT_EQ(unknowns(deck.dimension), 2);
  EXPECT_EQ(unknowns(Dimension::three), 3);
  EXPECT_EQ(std::get<Box>(deck.body[0].shape.form).max, (Point{4, 4, 0}));
  EXPECT_EQ(std::get<CrackSegment>(deck.cracks[0].form).end, (Point{2, 1, 0}));
  EXPECT_EQ(fixture::message_of(fixture::changed(fixture::flat_deck, "max: [4, 4]", "max: [4, 4, 0]")), "");
  EXPECT_EQ(fixture::message_of(fixture::changed(fixture::flat_deck, "plane-strain", "plane-stress")), "");
  // In 2-D a rectangle stands across the plane, and a disc has its normal in the plane.
  const std::string segment = "{segment: {start: [1, 1], end: [2, 1]}}";
  for (const char* crack : {"{rectangle: {corner: [1, 1, -1], edge1: [1, 0, 0], edge2: [0, 0, 2]}}",
                            "{disc: {center: [1, 1], normal: [0, 1], radius: 1}}"}) {
    EXPECT_EQ(fixture::message_of(fixture::changed(fixture::flat_deck, segment, crack)), "");
  }
}

TEST(Read, ShapesWithinShapes) {
  const std::string yaml = fixture::changed(
      fixture::base_deck, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
      "{difference: [{union: [{sphere: {center: [0, 0, 0], radius: 2}}, {cylinder: {start: [0, 0, 0], end: [0, 0, 9], "
      "radius: 1}}]}, {plate_with_hole: {min: [0, 0, 0], max: [1, 1, 1], center: [0.5, 0.5, 0], radius: 0.2}}]}");
  const Deck deck = read_text(yaml, "deck.yaml", fixture::schema());
  const auto& parts = std::get<Difference>(deck.body[0].shape.form).parts;
  ASSERT_EQ(parts.size(), 2u);
  const auto& inner = std::get<Union>(parts[0].form).parts;
  EXPECT_EQ(std::get<Sphere>(inner[0].form).radius, 2.0);
  EXPECT_EQ(std::get<Cylinder>(inner[1].form).end, (Point{0, 0, 9}));
  EXPECT_EQ(std::get<PlateWithHole>(parts[1].form).radius, 0.2);
}

TEST(Read, SetsAndLoadsOfEveryKind) {
  std::string yaml = fixture::changed(fixture::base_deck, "boundary:\n",
                                      "  corner: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
                                      "  pins: {ids: [0, 9007199254740993]}\n"
                                      "  whole: {body: block}\n"
                                      "boundary:\n"
                                      "  - {set: all, body_force: {y: \"-2*x\"}}\n"
                                      "  - {set: block, force: {x: 1}}\n");
  const Deck deck = read_text(yaml, "deck.yaml", fixture::schema());
  ASSERT_EQ(deck.sets.size(), 5u);
  EXPECT_EQ(std::get<SetBox>(deck.sets[2].form).max, (Point{1, 1, 1}));
  EXPECT_EQ(std::get<SetIds>(deck.sets[3].form).ids, (std::vector<long long>{0, 9007199254740993}));
  EXPECT_EQ(std::get<SetBody>(deck.sets[4].form).body, "block");
  EXPECT_EQ(deck.boundary[0].kind, LoadKind::body_force);
  EXPECT_DOUBLE_EQ((*deck.boundary[0].component[1])(3, 0, 0, 0), -6.0);
  EXPECT_EQ(deck.boundary[1].kind, LoadKind::force);
}

TEST(Read, AnchorsAndAliases) {
  const std::string yaml =
      fixture::changed(fixture::base_deck, "material: steel", "material: &m steel") + "title2: *m\n";
  EXPECT_THAT(fixture::message_of(yaml), ::testing::HasSubstr("title2 is not a key of a deck; did you mean title?"));
  std::string aliased = fixture::changed(fixture::base_deck, "{x: 0, y: 0, z: 0}", "&fixed {x: 0, y: 0, z: 0}");
  aliased = fixture::changed(aliased, "{z: \"0.3*t\"}", "*fixed");
  const Deck deck = read_text(aliased, "deck.yaml", fixture::schema());
  EXPECT_TRUE(deck.boundary[1].component[0].has_value());
}

TEST(Read, FilesAreFoundFromTheDecksFolder) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "perinox deck files";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "cloud.csv") << "x,y,z,volume\n0,0,0,1\n";
  std::ofstream(folder / "field.csv") << "x,y,z,ux,uy,uz\n0,0,0,0,0,0\n";
  std::ofstream(folder / "deck.yaml") << "dimension: 3\n"
                                         "body: [{name: b, shape: {file: cloud.csv}, material: m}]\n"
                                         "horizon: {ratio: 3}\n"
                                         "materials: {m: {model: elastic}}\n"
                                         "boundary: [{set: all, displacement: {table: ./field.csv}}]\n";
  const Deck deck = read((folder / "deck.yaml").string(), fixture::schema());
  EXPECT_EQ(std::get<CloudFile>(deck.body[0].shape.form).path, (folder / "cloud.csv").string());
  EXPECT_EQ(deck.body[0].spacing, 0.0);
  EXPECT_EQ(deck.boundary[0].table, (folder / "field.csv").string());
  EXPECT_EQ(deck.boundary[0].table_location.line, 5);
  const Deck again = read_text(write_resolved(deck), "/elsewhere/deck.resolved.yaml", fixture::schema());
  EXPECT_EQ(again.boundary[0].table, (folder / "field.csv").string());
  // In a folder of its own the names count from that folder, so that both can be moved together.
  const std::string results = (folder / "results/deck").string(), moved = write_resolved(deck, results);
  EXPECT_THAT(moved, ::testing::HasSubstr("table: \"../../field.csv\""));
  EXPECT_EQ(moved.find(folder.string()), std::string::npos);
  EXPECT_EQ(read_text(moved, results + "/deck.resolved.yaml", fixture::schema()).boundary[0].table,
            (folder / "field.csv").string());
  const std::vector<InputFile> files = input_files(deck);
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].key, "body[0].shape.file");
  EXPECT_EQ(files[1].key, "boundary[0].displacement.table");
  EXPECT_EQ(files[1].path, (folder / "field.csv").string());
  // A name that is absolute in the deck stays absolute.
  const Deck absolute = read((folder / "deck.yaml").string(), fixture::schema(),
                             {"body.0.shape.file=" + (folder / "cloud.csv").string()});
  EXPECT_THAT(write_resolved(absolute, results),
              ::testing::HasSubstr("file: \"" + (folder / "cloud.csv").string() + "\""));
  // A deck in a checkpoint names files that may be gone. Their place counts as no difference.
  const Deck saved = read_saved(fixture::changed(moved, "../../field.csv", "../gone.csv"), "saved", fixture::schema());
  EXPECT_TRUE(changed_keys(saved.resolved, deck.resolved).empty());

  const std::string part =
      "body: [{name: b, shape: {union: [{file: " + (folder / "cloud.csv").string() + "}]}, spacing: 1, material: m}]\n";
  EXPECT_THAT(fixture::message_of("dimension: 3\n" + part + "horizon: {ratio: 3}\nmaterials: {m: {model: elastic}}\n"),
              ::testing::StartsWith("deck.yaml:2:34: a point cloud cannot be part of a union"));
}

TEST(Deck, CutsBoundaryCellsWhereTheQuadratureCanDoWithIt) {
  const std::string aware = "quadrature=position-aware", whole = "quadrature=whole", cut = "body.0.boundary_cells=cut";
  EXPECT_TRUE(read_base({aware}).body[0].cut_cells);
  EXPECT_TRUE(read_base({aware, cut}).body[0].cut_cells);
  EXPECT_FALSE(read_base({aware, "body.0.boundary_cells=whole"}).body[0].cut_cells);
  EXPECT_FALSE(read_base({whole}).body[0].cut_cells);
  EXPECT_EQ(fixture::message_of(fixture::base_deck, {whole, cut}),
            "--set body.0.boundary_cells=cut: boundary_cells: cut needs quadrature: position-aware, which makes up for "
            "uneven volumes; change one of the two");
  const std::string cloud = "body.0.shape={file: " PERINOX_SOURCE_DIR "/inputs/imposed_field_points.csv}";
  EXPECT_FALSE(read_base({aware, cloud}).body[0].cut_cells);
  EXPECT_THAT(fixture::message_of(fixture::base_deck, {aware, cloud, cut}),
              ::testing::HasSubstr("is a point cloud, which has no cells that could be cut"));
}

TEST(Override, ReplacesAndAddsValues) {
  EXPECT_EQ(read_base({"body.0.spacing=0.25"}).body[0].spacing, 0.25);
  EXPECT_EQ(read_base({"solver.linear.tolerance=1e-3"}).solver.linear.tolerance, 1e-3);
  EXPECT_EQ(read_base({"horizon={length: 2}"}).horizon.length, 2.0);
  EXPECT_EQ(read_base({"materials.steel.yield_stress.tension=100"})
                .materials[0]
                .parameters.at("yield_stress")
                .at("tension")
                .number(),
            100);
  EXPECT_EQ(read_base({"output.fields=[damage]"}).output.fields, std::vector<std::string>{"damage"});
  EXPECT_EQ(read_base({"steps.count=5", "steps.count=6"}).steps.count, 6);
  EXPECT_EQ(read_base({"sets.foot.where=x == 1"}).sets[0].location.text(), "deck.yaml:18:9");
}

TEST(Override, IsCheckedLikeTheDeck) {
  const auto message = [](const std::string& text) { return fixture::message_of(fixture::base_deck, {text}); };
  EXPECT_EQ(message("body.0.spacing=-1"), "--set body.0.spacing=-1: spacing is -1 but must be greater than 0");
  EXPECT_EQ(message("solver.newtn.tolerance=1e-3"),
            "--set solver.newtn.tolerance=1e-3: newtn is not a key of solver; did you mean newton?");
  EXPECT_EQ(message("stpes.count=3"), "--set stpes.count=3: stpes is not a key of a deck; did you mean steps?");
  EXPECT_THAT(message("body.1.spacing=1"),
              ::testing::HasSubstr("body has 1 entry, counted from 0; there is no entry 1"));
  EXPECT_THAT(message("body.block.spacing=1"), ::testing::HasSubstr("name an entry by its number"));
  EXPECT_THAT(message("influence.power=1"), ::testing::HasSubstr("influence is 'constant' and has no keys"));
  EXPECT_THAT(message("horizon.length=2"), ::testing::HasSubstr("horizon has both ratio and length"));
  EXPECT_THAT(message("steps.count"), ::testing::HasSubstr("an override is written key.path=value"));
  EXPECT_THAT(message("=3"), ::testing::HasSubstr("an override is written key.path=value"));
  EXPECT_THAT(message("steps..count=3"), ::testing::HasSubstr("empty part"));
  EXPECT_THAT(message("steps.count="), ::testing::HasSubstr("count has no value"));
  EXPECT_THAT(message("steps={end: [}"), ::testing::StartsWith("--set steps={end: [}"));
}

}  // namespace
}  // namespace perinox::deck
