/// Each row has one mistake in a deck, a point cloud or a displacement table. `perinox check` must end with status 2,
/// say exactly one line, which names the place and what to do, and leave nothing behind.
#include <ostream>

#include "decks.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace perinox::cli {
namespace {

struct Mistake {
  const char* name;
  const std::string* deck;  ///< deck that is right before `from` is replaced by `to`
  const char* from;
  const char* to;
  const char* sentence;  ///< everything that is said; {dir} stands for the folder
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.name; }

const Mistake mistakes_in_decks[] = {
    {"two_documents", &base_deck, "sets:\n", "---\nsets:\n",
     "deck.yaml:17:1: a second YAML document starts here; a deck is one document, so remove the line ---"},
    {"key_without_value", &base_deck, "spacing: 1.0",
     "spacing:", "deck.yaml:6:5: spacing has no value; give it a number or remove it"},
    {"key_twice", &base_deck, "influence: constant\n", "influence: constant\ninfluence: inverse\n",
     "deck.yaml:10:1: influence is written twice in a deck (first at line 9); remove one"},
    {"unknown_key_of_a_deck", &base_deck,
     "influence:", "influense:", "deck.yaml:9:1: influense is not a key of a deck; did you mean influence?"},
    {"unknown_key_of_a_body", &base_deck,
     "    spacing:", "    spaceing:", "deck.yaml:6:5: spaceing is not a key of a body; did you mean spacing?"},
    {"unknown_shape", &base_deck, "{box:", "{cube:",
     "deck.yaml:5:13: cube is not a key of a shape; its keys are box, cylinder, sphere, plate_with_hole, union, "
     "difference and file"},
    {"unknown_key_of_a_box", &base_deck, "max: [3, 3, 4]", "maxx: [3, 3, 4]",
     "deck.yaml:5:35: maxx is not a key of body.0.shape.box; did you mean max?"},
    {"unknown_key_of_horizon", &base_deck, "{ratio: 2.015}", "{ration: 2.015}",
     "deck.yaml:8:11: ration is not a key of horizon; did you mean ratio?"},
    {"unknown_key_of_a_material", &base_deck, "yield_stress", "yield_stess",
     "deck.yaml:16:5: yield_stess is not a key of a material; did you mean yield_stress?"},
    {"unknown_test_of_yield_stress", &base_deck, "{tension: 203.1}", "{torsion: 203.1}",
     "deck.yaml:16:20: torsion is not a key of materials.steel.yield_stress; did you mean tension?"},
    {"unknown_key_of_a_set", &base_deck,
     "head: {where:", "head: {wher:", "deck.yaml:19:10: wher is not a key of a set; did you mean where?"},
    {"unknown_key_of_a_load", &base_deck, "{set: foot, displacement:", "{set: foot, displacements:",
     "deck.yaml:21:17: displacements is not a key of a load; did you mean displacement?"},
    {"unknown_component", &base_deck, "{z: \"0.01*t\"}", "{w: \"0.01*t\"}",
     "deck.yaml:22:32: w is not a key of boundary.1.displacement; its keys are x, y, z and table"},
    {"unknown_key_of_steps", &base_deck, "count: 2", "number: 2",
     "deck.yaml:23:19: number is not a key of steps; its keys are end, count, adaptive, max_cuts, time_limit and "
     "control"},
    {"unknown_key_of_solver", &base_deck, "tangent: matrix-free", "tangents: matrix-free",
     "deck.yaml:25:3: tangents is not a key of solver; did you mean tangent?"},
    {"unknown_key_of_newton", &base_deck, "{tolerance: 1e-8}", "{tol: 1e-8}",
     "deck.yaml:26:12: tol is not a key of solver.newton; did you mean tolerance?"},
    {"unknown_key_of_linear", &base_deck, "{preconditioner: automatic}", "{precond: automatic}",
     "deck.yaml:27:12: precond is not a key of solver.linear; did you mean preconditioner?"},
    {"unknown_key_of_output", &base_deck, "{every: 1,", "{evry: 1,",
     "deck.yaml:28:10: evry is not a key of output; did you mean every?"},
    {"unknown_key_of_history", &base_deck, "component: z}", "direction: z}",
     "deck.yaml:30:34: direction is not a key of a history entry; did you mean component?"},
    {"unknown_crack", &base_deck, "materials:\n",
     "cracks: [{disk: {center: [0, 0, 1], normal: [0, 0, 1], radius: 1}}]\nmaterials:\n",
     "deck.yaml:11:11: disk is not a key of a crack; did you mean disc?"},
    {"missing_dimension", &base_deck, "dimension: 3\n", "",
     "deck.yaml:1:1: a deck needs the key dimension (one of 3, plane-strain or plane-stress): 3 for a solid, or a "
     "plane state with two unknowns a particle."},
    {"missing_horizon", &base_deck, "horizon: {ratio: 2.015}\n", "",
     "deck.yaml:1:1: a deck needs the key horizon (a map with exactly one of ratio or length): Distance up to "
     "which two particles interact."},
    {"missing_yield_stress", &base_deck, "    yield_stress: {tension: 203.1}\n", "",
     "deck.yaml:13:5: material steel needs the key yield_stress (a map with exactly one of tension or shear), or a "
     "hardening_table"},
    {"missing_spacing", &base_deck, "    spacing: 1.0\n", "",
     "deck.yaml:4:5: the body block needs the key spacing: only a point cloud can do without"},
    {"missing_component", &base_deck, ", component: z}", "}",
     "deck.yaml:30:5: the history entry pull needs the key component: x, y or z"},
    {"text_for_a_number", &base_deck, "bulk_modulus: 160e3", "bulk_modulus: stiff",
     "deck.yaml:14:19: bulk_modulus must be a number, but 'stiff' was found"},
    {"not_a_number", &base_deck, "bulk_modulus: 160e3", "bulk_modulus: .nan",
     "deck.yaml:14:19: bulk_modulus must be a finite number, but '.nan' was found"},
    {"decimal_comma", &base_deck, "spacing: 1.0", "spacing: 1,0",
     "deck.yaml:6:14: spacing must be a number, but '1,0' was found; write 1.0"},
    {"fraction_of_a_step", &base_deck, "count: 2", "count: 2.5",
     "deck.yaml:23:26: count must be a whole number, but '2.5' was found"},
    {"no_steps", &base_deck, "count: 2", "count: 0",
     "deck.yaml:23:26: count is 0 but must be at least 1 and at most 1000000000"},
    {"negative_spacing", &base_deck, "spacing: 1.0", "spacing: -1",
     "deck.yaml:6:14: spacing is -1 but must be greater than 0"},
    {"ratio_below_one", &base_deck, "ratio: 2.015", "ratio: 0.9",
     "deck.yaml:8:18: ratio is 0.9 but must be at least 1"},
    {"zero_yield_stress", &base_deck, "tension: 203.1", "tension: 0",
     "deck.yaml:16:29: tension is 0 but must be greater than 0"},
    {"two_kinds_of_horizon", &base_deck, "{ratio: 2.015}", "{ratio: 2.015, length: 2}",
     "deck.yaml:8:25: horizon has both ratio and length, but these exclude each other; keep one"},
    {"unknown_model", &base_deck, "model: elastic-plastic", "model: plastic",
     "deck.yaml:13:12: model cannot be 'plastic'; did you mean elastic?"},
    {"key_of_another_model", &base_deck, "model: elastic-plastic", "model: elastic",
     "deck.yaml:16:5: yield_stress is not a key of a material of the model elastic; it is one of elastic-plastic"},
    {"unknown_quadrature", &base_deck, "quadrature: whole", "quadrature: gauss",
     "deck.yaml:10:13: quadrature cannot be 'gauss'; it can be whole, partial-volume, taper-inside, "
     "position-aware or surface-energy"},
    {"unknown_field", &base_deck, "[displacement, force]", "[displacement, heat]",
     "deck.yaml:28:43: there is no output field 'heat'; there is displacement, force, dilatation, damage, "
     "stored_energy, weighted_volume, stress, strain, von_mises_stress, plastic_work, velocity, fragment, "
     "plastic_multiplier and equivalent_plastic_strain"},
    {"unknown_material", &base_deck, "material: steel", "material: stele",
     "deck.yaml:7:15: stele is not the name of a material; did you mean steel?"},
    {"unknown_set", &base_deck, "{set: head, displacement", "{set: haed, displacement",
     "deck.yaml:22:11: haed is not the name of a set or body; did you mean head?"},
    {"unknown_set_in_history", &base_deck, "reaction: head", "reaction: top",
     "deck.yaml:30:28: top is not the name of a set or body; there is all, foot, head and block"},
    {"formula_with_unknown_name", &base_deck, "\"0.01*t\"", "\"0.01*time\"",
     "deck.yaml:22:35: the formula '0.01*time' cannot be read at character 6: time is not known; a formula may use "
     "x, y, z, t, pi and functions such as sin, exp, sqrt"},
    {"formula_not_finished", &base_deck, "\"0.01*t\"", "\"0.01*\"",
     "deck.yaml:22:35: the formula '0.01*' cannot be read at character 6: it ends too early"},
    {"set_that_uses_t", &base_deck, "\"z > 3\"", "\"z > 3*t\"",
     "deck.yaml:19:17: the formula of the set head uses t, but a set is the same at every t; use only x, y and z"},
    {"z_in_two_dimensions", &flat_deck, "{x: 0, y: 0}", "{x: 0, y: 0, z: 0}",
     "deck.yaml:7:54: displacement has a z component, but this deck is 2-D; remove z"},
    {"missing_cloud", &base_deck, "{box: {min: [0, 0, 0], max: [3, 3, 4]}}", "{file: nowhere.csv}",
     "deck.yaml:5:19: the file nowhere.csv (file) does not exist; relative names start at the deck's folder, so "
     "this one was looked for as {dir}/nowhere.csv"},
    {"missing_table", &base_deck, "{z: \"0.01*t\"}", "{table: nowhere.csv}",
     "deck.yaml:22:39: the file nowhere.csv (table) does not exist; relative names start at the deck's folder, so "
     "this one was looked for as {dir}/nowhere.csv"},
    {"empty_set", &base_deck, "\"z > 3\"", "\"z > 30\"",
     "deck.yaml:19:9: the set head is empty: none of the 36 particles is in it; widen its condition or take the "
     "set out (the particles lie from (0.5, 0.5, 0.5) to (2.5, 2.5, 3.5))"},
    {"set_of_an_id_that_is_not_there", &base_deck, "{where: \"z > 3\"}", "{ids: [3, 36]}",
     "deck.yaml:19:9: the set head names particle 36, but the particles are numbered from 0 to 35; take that id out"},
    {"body_without_particles", &base_deck, "{box: {min: [0, 0, 0], max: [3, 3, 4]}}",
     "{difference: [{box: {min: [0, 0, 0], max: [3, 3, 4]}}, {sphere: {center: [0, 0, 0], radius: 9}}]}",
     "deck.yaml:5:12: the body block has no particles: none of the 3 x 3 x 4 centres of its lattice is inside its "
     "shape; make the spacing smaller than 1"},
    {"too_many_particles", &base_deck, "spacing: 1.0", "spacing: 1.0e-6",
     "deck.yaml:5:12: the body block would have about 3.6e+19 particles at spacing 1e-06, more than 2e+09; make "
     "the spacing larger, or check that spacing and shape are in the same unit"},
    {"horizon_of_a_million_spacings", &base_deck, "ratio: 2.015", "ratio: 1e6",
     "deck.yaml:8:10: the horizon reaches 1e+06 spacings of 1 far, more than 100: each particle could have about "
     "4.2e+18 neighbours; make it smaller, 3 spacings are usual"},
    {"spacing_beyond_double_precision", &base_deck, "spacing: 1.0", "spacing: 1e-300",
     "deck.yaml:4:5: the spacing 1e-300 of the body block is out of what double precision can compute with; choose "
     "units in which it lies between 1e-25 and 1e+25"},
    {"bodies_that_overlap", &base_deck, "horizon:",
     "  - {name: twin, shape: {box: {min: [0, 0, 3], max: [3, 3, 5]}}, spacing: 1, material: steel}\nhorizon:",
     "deck.yaml:8:5: the body twin overlaps the body block by about 9, for example at (1.5, 0.25, 3.25), where "
     "material "
     "would count twice; take one shape from the other with difference, or write overlap: later-wins"},
    {"empty_family", &base_deck, "{ratio: 2.015}", "{length: 0.5}",
     "deck.yaml:8:10: the horizon 0.5 is shorter than the spacing 1 of the body block, so that its particles have no "
     "neighbours; a horizon of 3 spacings is usual: make it 3, or the spacing smaller"},
    {"spacing_larger_than_the_body", &base_deck, "spacing: 1.0", "spacing: 50",
     "deck.yaml:6:14: the spacing 50 is larger than the whole body block, whose longest side is 4; make it a tenth of "
     "that or less, or check that both are in the same unit"},
    {"body_apart_from_the_rest", &base_deck, "horizon:",
     "  - {name: crumb, shape: {box: {min: [9, 9, 9], max: [10, 10, 10]}}, spacing: 1, material: steel}\nhorizon:",
     "deck.yaml:8:5: particle 36 at (9.5, 9.5, 9.5) has no neighbour within the horizon 2.015; make the horizon "
     "larger, or take "
     "the particle out"},
    {"crack_that_cuts_a_whole_family", &base_deck, "materials:\n",
     "cracks:\n  - rectangle: {corner: [-1, -1, 1], edge1: [9, 0, 0], edge2: [0, 9, 0]}\n  - rectangle: {corner: [-1, "
     "1, -1], edge1: [9, 0, 0], edge2: [0, 0, 9]}\n  - rectangle: {corner: [1, -1, -1], edge1: [0, 9, 0], edge2: [0, "
     "0, 9]}\nmaterials:\n",
     "deck.yaml:4:5: particle 0 at (0.5, 0.5, 0.5) has lost all its bonds to pre-cracks; move the cracks, or make the "
     "horizon "
     "larger"},
    {"one_elastic_constant", &base_deck, "    shear_modulus: 80e3\n", "",
     "deck.yaml:13:5: material steel needs two elastic constants and has 1: give any two of bulk_modulus, "
     "shear_modulus, young_modulus, poisson_ratio, lame_lambda"},
    {"constants_that_contradict", &base_deck, "    shear_modulus: 80e3\n",
     "    shear_modulus: 80e3\n    poisson_ratio: 0.3\n",
     "deck.yaml:13:5: the 3 elastic constants of material steel contradict each other; give two of them and leave "
     "the others out"},
    {"constants_that_do_not_belong_together", &base_deck, "    shear_modulus: 80e3\n", "    young_modulus: 2000e3\n",
     "deck.yaml:13:5: the elastic constants of material steel do not give a positive bulk and shear modulus; check "
     "that the two belong together"},
    {"poisson_ratio_of_one_half", &base_deck, "    shear_modulus: 80e3\n", "    poisson_ratio: 0.5\n",
     "deck.yaml:15:20: poisson_ratio is 0.5 but must be greater than -1 and at most 0.4999999"},
    {"continuum_yield_in_two_dimensions", &flat_deck, "steel: {model: elastic,",
     "steel: {model: elastic-plastic, yield_stress: {shear: 1}, yield_scaling: continuum,",
     "deck.yaml:5:76: the continuum yield value (Eq. 51) is that of a solid; in 2-D leave yield_scaling out"},
    {"plasticity_without_dilatation_in_two_dimensions", &flat_deck, "steel: {model: elastic,",
     "steel: {model: elastic-plastic, yield_stress: {shear: 1}, dilatation: false,",
     "deck.yaml:5:73: plasticity in the plane needs the dilatation, which the strain out of the plane follows; leave "
     "dilatation out, or use dimension: 3"},
    {"nothing_held", &base_deck, "displacement: {x: 0, y: 0, z: 0}}\n  - {set: head, displacement: {z: \"0.01*t\"}}",
     "force: {x: 1}}",
     "deck.yaml:21:3: nothing holds the body: no displacement is prescribed anywhere; add a boundary entry with "
     "displacement"},
    {"no_loads", &flat_deck, "boundary: [{set: left, displacement: {x: 0, y: 0}}]\n", "",
     "deck.yaml:1:1: nothing holds the body: no displacement is prescribed anywhere; add a boundary entry with "
     "displacement"},
    {"displacement_not_a_number", &base_deck, "\"0.01*t\"", "\"sqrt(x - 1)*t\"",
     "deck.yaml:22:5: the z component is not a finite number at (0.5, 0.5, 3.5) for t = 0.5; check the formula "
     "sqrt(x - 1)*t"},
    {"displacement_infinite_at_the_end", &base_deck, "\"0.01*t\"", "\"0.01/(t - 1)\"",
     "deck.yaml:22:5: the z component is not a finite number at (0.5, 0.5, 3.5) for t = 1; check the formula "
     "0.01/(t - 1)"},
    {"force_not_a_number", &base_deck, "{set: head, displacement: {z: \"0.01*t\"}}",
     "{set: head, force: {y: \"log(t - 2)\"}}",
     "deck.yaml:22:5: the y component is not a finite number at (0.5, 0.5, 3.5) for t = 0.5; check the formula "
     "log(t - 2)"},
    {"body_force_not_a_number", &flat_deck, "y: 0}}]", "y: 0}}, {set: all, body_force: {y: \"acos(1 + x)\"}}]",
     "deck.yaml:7:53: the y component is not a finite number at (0.5, 0.5, 0) for t = 0.1; check the formula "
     "acos(1 + x)"},
    {"ilu_without_a_matrix", &base_deck, "preconditioner: automatic", "preconditioner: ilu",
     "deck.yaml:27:28: the preconditioner ilu needs the assembled matrix; leave tangent: matrix-free out of solver, or "
     "take two-level"},
    {"chebyshev_without_a_matrix", &base_deck, "preconditioner: automatic", "preconditioner: chebyshev",
     "deck.yaml:27:28: the preconditioner chebyshev needs the assembled matrix; leave tangent: matrix-free out of "
     "solver, or take two-level"},
    {"gauss_seidel_without_a_matrix", &base_deck, "preconditioner: automatic", "preconditioner: symmetric-gauss-seidel",
     "deck.yaml:27:28: the preconditioner symmetric-gauss-seidel needs the assembled matrix; leave tangent: "
     "matrix-free out of solver, or take two-level"},
    {"steps_without_a_preconditioner", &base_deck, "preconditioner: automatic",
     "preconditioner: none, chebyshev_steps: 3",
     "deck.yaml:27:51: chebyshev_steps needs the matrix-free tangent with two-level or block-jacobi; take it out, or "
     "what asks for another preconditioner or the assembled matrix"},
    {"steps_that_are_even", &base_deck, "preconditioner: automatic", "chebyshev_steps: 2",
     "deck.yaml:27:29: chebyshev_steps cannot be '2'; it can be automatic, 1, 3 or 5"},
    {"direct_without_a_matrix", &base_deck, "preconditioner: automatic", "method: direct",
     "deck.yaml:27:20: the direct method factorises the assembled matrix; leave tangent: matrix-free out of solver, or "
     "take method: automatic"},
    {"direct_with_a_preconditioner", &base_deck,
     "tangent: matrix-free\n  newton: {tolerance: 1e-8}\n  linear: {preconditioner: automatic}",
     "linear: {method: direct, preconditioner: ilu}",
     "deck.yaml:25:44: the direct method takes no preconditioner, but ilu is asked for; take one of the two out"},
    {"nothing_held_sideways", &base_deck, "displacement: {x: 0, y: 0, z: 0}", "displacement: {z: 0}",
     "deck.yaml:21:3: the prescribed displacements do not hold the body block (36 particles around (1.5, 1.5, 2)): it "
     "can rotate about the axis through (1.5, 1.5, 2) along z, move along x, move along y; prescribe displacements "
     "against these"},
    {"nothing_held_against_a_turn", &flat_deck, "left: {where: \"x < 1\"}", "left: {ids: [3]}",
     "deck.yaml:7:11: the prescribed displacements do not hold the body plate (9 particles around (1.5, 1.5)): it can "
     "rotate about (0.5, 1.5); prescribe displacements against that"},
    {"body_apart_that_nothing_holds", &base_deck, "horizon:",
     "  - {name: lid, shape: {box: {min: [0, 0, 9], max: [3, 3, 11]}}, spacing: 1, material: steel}\nhorizon:",
     "deck.yaml:22:3: the prescribed displacements do not hold the body lid (18 particles around (1.5, 1.5, 10)): it "
     "can "
     "rotate about the axis through (1.5, 1.5, 10) along z, move along x, move along y; prescribe displacements "
     "against "
     "these"},
    {"body_apart_that_nothing_touches", &flat_deck, "body: [",
     "body: [{name: crumb, shape: {box: {min: [8, 0], max: [10, 2]}}, spacing: 1, material: steel}, ",
     "deck.yaml:7:11: nothing holds the body crumb (4 particles around (9, 1)): none of its displacements is "
     "prescribed "
     "and no bond joins it to the rest; prescribe some, or bring it nearer to the rest than the horizon 2.015"},
    {"piece_that_a_crack_cuts_free", &base_deck, "materials:\n",
     "cracks:\n  - rectangle: {corner: [-1, -1, 2], edge1: [9, 0, 0], edge2: [0, 9, 0]}\nmaterials:\n",
     "deck.yaml:23:3: the prescribed displacements do not hold a piece of the body block (18 particles around (1.5, "
     "1.5, "
     "3), the first is particle 18 at (0.5, 0.5, 2.5)): it can rotate about the axis through (1.5, 1.5, 3) along z, "
     "move "
     "along x, move along y; prescribe displacements against these"},
};

class MalformedDeck : public ::testing::TestWithParam<Mistake> {};

TEST_P(MalformedDeck, IsRefusedInOneSentence) {
  const Mistake& mistake = GetParam();
  const Folder folder;
  folder.write("deck.yaml", changed(*mistake.deck, mistake.from, mistake.to));
  expect_refusal(folder, {"check", "deck.yaml"}, mistake.sentence);
}

INSTANTIATE_TEST_SUITE_P(Cli, MalformedDeck, ::testing::ValuesIn(mistakes_in_decks),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(Malformed, TheDecksAreRightBeforeTheyAreBroken) {
  const Folder folder;
  folder.write("cloud.csv", cloud);
  folder.write("field.csv", field);
  for (const std::string* text : {&base_deck, &flat_deck, &cloud_deck}) {
    folder.write("deck.yaml", *text);
    const Outcome outcome = folder.perinox({"check", "deck.yaml"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.error, "");
  }
}

// `run` and `verify` refuse as `check` does, before a results folder is made. There is one row for each room: deck,
// materials, body, bonds and the solver.
TEST(Malformed, RunAndVerifyRefuseAsCheckDoes) {
  int rows = 0;
  for (const Mistake& mistake : mistakes_in_decks) {
    const std::string name = mistake.name;
    if (name != "unknown_key_of_a_material" && name != "constants_that_contradict" && name != "empty_set" &&
        name != "empty_family" && name != "nothing_held" && name != "nothing_held_sideways" &&
        name != "ilu_without_a_matrix")
      continue;
    ++rows;
    SCOPED_TRACE(name);
    const Folder folder;
    folder.write("deck.yaml", changed(*mistake.deck, mistake.from, mistake.to));
    expect_refusal(folder, {"run", "deck.yaml"}, mistake.sentence);
    expect_refusal(folder, {"run", "deck.yaml", "--output", "elsewhere", "--quiet"}, mistake.sentence);
    expect_refusal(folder, {"verify", "deck.yaml"}, mistake.sentence);
  }
  EXPECT_EQ(rows, 7);
}

TEST(Malformed, OnTwoRanksTheSentenceIsSaidOnce) {
  int rows = 0;
  for (const Mistake& mistake : mistakes_in_decks) {
    const std::string name = mistake.name;
    if (name != "unknown_key_of_a_deck" && name != "empty_set" && name != "bodies_that_overlap" &&
        name != "displacement_not_a_number" && name != "piece_that_a_crack_cuts_free")
      continue;
    ++rows;
    SCOPED_TRACE(name);
    const Folder folder;
    folder.write("deck.yaml", changed(*mistake.deck, mistake.from, mistake.to));
    const Outcome outcome = folder.perinox_on_ranks(2, {"run", "deck.yaml"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    // mpirun adds lines of its own about the exit status.
    std::size_t times = 0;
    const std::string sentence = in_folder(mistake.sentence, folder);
    for (const std::string& line : lines_of(outcome.error)) times += line == sentence ? 1 : 0;
    EXPECT_EQ(times, 1) << outcome.error;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"deck.yaml"});
  }
  EXPECT_EQ(rows, 5);
}

}  // namespace
}  // namespace perinox::cli
