/// Decks with one mistake each: the error must have the right place and sentence.
#include <ostream>

#include "deck/fixture.hpp"

namespace perinox::deck {
namespace {

struct Mistake {
  const char* name;
  const std::string* deck;  ///< deck that reads if `from` is not replaced by `to`
  const char* from;
  const char* to;
  const char* place;     ///< line:column
  const char* sentence;  ///< the message's text behind the place, or its beginning
};

void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.from << " -> " << mistake.to; }

const std::string* const base = &fixture::base_deck;
const std::string* const flat = &fixture::flat_deck;

const Mistake mistakes[] = {
    {"unknown_key_of_the_deck", base, "influence:", "influnce:", "9:1",
     "influnce is not a key of a deck; did you mean influence?"},
    {"unknown_key_far_from_all", base, "influence: constant", "colour: red", "9:1",
     "colour is not a key of a deck; its keys are title, dimension, body, overlap, bond_bodies, bonds, horizon, "
     "influence, "
     "quadrature, deformation, cracks, materials, sets, boundary, dynamics, initial_velocity, explicit, fracture, "
     "fallback, hand_over, steps, arc_length, solver, output and history"},
    {"unknown_key_of_a_material", base, "yield_stress", "yield_stess", "16:5",
     "yield_stess is not a key of a material; did you mean yield_stress?"},
    {"key_of_another_model", base, "model: elastic-plastic", "model: elastic", "16:5",
     "yield_stress is not a key of a material of the model elastic; it is one of elastic-plastic"},
    {"unknown_key_of_a_body", base, "spacing: 1.0", "spacings: 1.0", "6:5",
     "spacings is not a key of a body; did you mean spacing?"},
    {"unknown_key_of_a_load", base, "  - set: head", "  - sett: head", "22:5",
     "sett is not a key of a load; did you mean set?"},
    {"unknown_key_of_a_shape", base, "{box: {min", "{bix: {min", "5:13",
     "bix is not a key of a shape; did you mean box?"},
    {"unknown_key_of_a_box", base, "max: [4, 4, 8]", "maximum: [4, 4, 8]", "5:35",
     "maximum is not a key of body.0.shape.box; did you mean max?"},
    {"unknown_key_of_a_component", base, "{z: \"0.3*t\"}", "{w: 1}", "23:20",
     "w is not a key of boundary.1.displacement; its keys are x, y, z and table"},
    {"unknown_key_of_newton", base, "newton: {tolerance", "newton: {tolerence", "27:12",
     "tolerence is not a key of solver.newton; did you mean tolerance?"},
    {"unknown_key_of_a_history_entry", base, "component: z", "direction: z", "30:34",
     "direction is not a key of a history entry; did you mean component?"},
    {"unknown_key_of_a_set", base, "head: {where:", "head: {were:", "19:10",
     "were is not a key of a set; did you mean where?"},
    {"unknown_key_of_steps", base, "count: 20", "counts: 20", "24:19",
     "counts is not a key of steps; did you mean count?"},
    {"missing_dimension", base, "dimension: 3\n", "", "1:1",
     "a deck needs the key dimension (one of 3, plane-strain or plane-stress): 3 for a solid, or a plane state with "
     "two unknowns a particle."},
    {"missing_body_name", base, "  - name: block\n    shape", "  - shape", "4:5",
     "a body needs the key name (a text): Name of the body; sets, loads and histories may refer to it."},
    {"missing_shape", base, "    shape: {box: {min: [0, 0, 0], max: [4, 4, 8]}}\n", "", "4:5",
     "a body needs the key shape (a map with exactly one of box, cylinder, sphere, plate_with_hole, union, difference "
     "or file): The region filled with particles: exactly one of the shapes."},
    {"missing_material", base, "    material: steel\n", "", "4:5",
     "a body needs the key material (a text): Name of one of the materials."},
    {"missing_model", base, "    model: elastic-plastic\n", "", "13:5",
     "a material needs the key model (one of elastic or elastic-plastic): The material model, which decides the other "
     "keys."},
    {"mistyped_model_key", base, "    model: elastic-plastic\n", "    modle: elastic-plastic\n", "13:5",
     "modle is not a key of a material; did you mean model?"},
    {"missing_key_of_a_model", base, "    yield_stress: {tension: 203.1}\n", "", "13:5",
     "a material needs the key yield_stress (a map with exactly one of tension or shear): Yield stress."},
    {"missing_box_corner", base, ", max: [4, 4, 8]", "", "5:18",
     "body.0.shape.box needs the key max (a list of 3 numbers, or 2 in 2-D): Corner with the largest coordinates."},
    {"missing_set_of_a_load", base, "{set: foot, displacement", "{displacement", "21:5",
     "a load needs the key set (a text): Where the load acts: a set's or body's name, or all."},
    {"missing_component", base, ", component: z", "", "30:5",
     "the history entry pull needs the key component: x, y or z"},
    {"missing_spacing", base, "    spacing: 1.0\n", "", "4:5",
     "the body block needs the key spacing: only a point cloud can do without"},
    {"text_for_a_number", base, "bulk_modulus: 160e3", "bulk_modulus: stiff", "14:19",
     "bulk_modulus must be a number, but 'stiff' was found"},
    {"quoted_number", base, "bulk_modulus: 160e3", "bulk_modulus: \"160e3\"", "14:19",
     "bulk_modulus must be a number; write 160e3 without quotes"},
    {"comma_in_a_number", base, "spacing: 1.0", "spacing: 1,0", "6:14",
     "spacing must be a number, but '1,0' was found; write 1.0"},
    {"fortran_exponent", base, "bulk_modulus: 160e3", "bulk_modulus: 160d3", "14:19",
     "bulk_modulus must be a number, but '160d3' was found; write 160e3"},
    {"list_for_a_number", base, "spacing: 1.0", "spacing: [1, 1]", "6:14",
     "spacing must be a number, but a list was found"},
    {"map_for_a_number", base, "spacing: 1.0", "spacing: {x: 1}", "6:14",
     "spacing must be a number, but a map was found"},
    {"number_for_a_list", base, "min: [0, 0, 0]", "min: 0", "5:24",
     "min must be a list of 3 numbers, or 2 in 2-D, but '0' was found"},
    {"number_for_a_map", base, "horizon: {ratio: 3.015}", "horizon: 3.015", "8:10",
     "horizon must be a map with exactly one of ratio or length, but '3.015' was found"},
    {"list_for_a_map", base, "steps: {end: 1.0, count: 20}", "steps: [1.0, 20]", "24:8",
     "steps must be a map with the keys end, count, adaptive, max_cuts, time_limit and control, but a list was found"},
    {"map_for_a_list", base, "fields: [displacement, force]", "fields: {a: 1}", "28:28",
     "fields must be a list, but a map was found"},
    {"not_a_number", base, "spacing: 1.0", "spacing: .nan", "6:14",
     "spacing must be a finite number, but '.nan' was found"},
    {"infinite", base, "spacing: 1.0", "spacing: .inf", "6:14",
     "spacing must be a finite number, but '.inf' was found"},
    {"plainly_infinite", base, "spacing: 1.0", "spacing: inf", "6:14",
     "spacing must be a finite number, but 'inf' was found"},
    {"too_large", base, "bulk_modulus: 160e3", "bulk_modulus: 1e999", "14:19",
     "bulk_modulus must be a number that double precision can hold, but '1e999' was found"},
    {"infinite_expression", base, "{x: 0, y: 0, z: 0}", "{x: .inf}", "21:35",
     "x must be a finite number or a formula, but '.inf' was found"},
    {"fraction_for_an_integer", base, "count: 20", "count: 20.5", "24:26",
     "count must be a whole number, but '20.5' was found"},
    {"point_in_an_integer", base, "count: 20", "count: 20.0", "24:26",
     "count must be a whole number, but '20.0' was found; write 20"},
    {"text_for_an_integer", base, "count: 20", "count: many", "24:26",
     "count must be a whole number, but 'many' was found"},
    {"integer_beyond_64_bits", base, "count: 20", "count: 99999999999999999999", "24:26",
     "count must be a whole number, but '99999999999999999999' was found"},
    {"yes_for_a_boolean", base, "count: 20", "adaptive: yes", "24:29",
     "adaptive must be true or false, but 'yes' was found"},
    {"number_for_a_boolean", base, "count: 20", "adaptive: 1", "24:29",
     "adaptive must be true or false, but '1' was found"},
    {"empty_value", base, "spacing: 1.0", "spacing:", "6:5", "spacing has no value; give it a number or remove it"},
    {"empty_optional_value", base, "influence: constant", "influence:", "9:1",
     "influence has no value; give it one of constant, inverse or polynomial or remove it"},
    {"empty_title", base, "title: base", "title: ''", "1:8", "title is empty; give it a text"},
    {"negative_spacing", base, "spacing: 1.0", "spacing: -1.0", "6:14", "spacing is -1.0 but must be greater than 0"},
    {"zero_spacing", base, "spacing: 1.0", "spacing: 0", "6:14", "spacing is 0 but must be greater than 0"},
    {"ratio_below_one", base, "ratio: 3.015", "ratio: 0.5", "8:18", "ratio is 0.5 but must be at least 1"},
    {"zero_horizon", base, "ratio: 3.015", "length: 0", "8:19", "length is 0 but must be greater than 0"},
    {"no_steps", base, "count: 20", "count: 0", "24:26", "count is 0 but must be at least 1 and at most 1000000000"},
    {"tolerance_above_one", base, "tolerance: 1e-8", "tolerance: 2", "27:23",
     "tolerance is 2 but must be greater than 0 and at most 1"},
    {"too_many_cuts", base, "count: 20", "max_cuts: 100", "24:29",
     "max_cuts is 100 but must be at least 0 and at most 60"},
    {"negative_material_choice", base, "tension: 203.1", "tension: -1", "16:29",
     "tension is -1 but must be greater than 0"},
    {"duplicate_key", base, "quadrature: whole", "influence: constant", "10:1",
     "influence is written twice in a deck (first at line 9); remove one"},
    {"duplicate_key_in_a_flow_map", base, "{end: 1.0, count: 20}", "{end: 1.0, end: 2}", "24:19",
     "end is written twice in steps (first at line 24); remove one"},
    {"duplicate_material", base, "sets:\n", "  steel: {model: elastic}\nsets:\n", "17:3",
     "steel is written twice in materials (first at line 12); remove one"},
    {"choice_with_none", base, "horizon: {ratio: 3.015}", "horizon: {}", "8:10",
     "horizon needs exactly one of ratio or length, but has none"},
    {"choice_with_two", base, "horizon: {ratio: 3.015}", "horizon: {ratio: 3.015, length: 1}", "8:25",
     "horizon has both ratio and length, but these exclude each other; keep one"},
    {"material_choice_with_two", base, "{tension: 203.1}", "{tension: 203.1, shear: 100}", "16:36",
     "materials.steel.yield_stress has both tension and shear, but these exclude each other; keep one"},
    {"load_with_none", base, "  - set: head\n    displacement: {z: \"0.3*t\"}", "  - set: head", "22:5",
     "a load needs exactly one of displacement, force, body_force, traction, pressure or velocity, but has none"},
    {"load_with_two", base, "    displacement: {z: \"0.3*t\"}", "    displacement: {z: \"0.3*t\"}\n    force: {x: 1}",
     "24:5", "a load has both displacement and force, but these exclude each other; keep one"},
    {"displacement_with_nothing", base, "{x: 0, y: 0, z: 0}", "{}", "21:31",
     "boundary.0.displacement is empty; it needs x, y, z or table"},
    {"displacement_with_table_and_component", base, "{x: 0, y: 0, z: 0}", "{table: deck.yaml, z: 0}", "21:50",
     "boundary.0.displacement has both z and table, but these exclude each other; keep one"},
    {"history_with_two", base, "reaction: head", "reaction: head, yielded: all", "30:34",
     "a history entry has both reaction and yielded, but these exclude each other; keep one"},
    {"unknown_word", base, "matrix-free", "matrixfree", "26:12",
     "tangent cannot be 'matrixfree'; did you mean matrix-free?"},
    {"unknown_word_far_from_all", base, "matrix-free", "fast", "26:12",
     "tangent cannot be 'fast'; it can be auto, matrix-free or assembled"},
    {"two_dimensions", base, "dimension: 3", "dimension: 2", "2:12",
     "dimension cannot be '2'; it can be 3, plane-strain or plane-stress"},
    {"unknown_model", base, "model: elastic-plastic", "model: elastic-plastik", "13:12",
     "model cannot be 'elastic-plastik'; did you mean elastic-plastic?"},
    {"unknown_field", base, "[displacement, force]", "[displacement, heat]", "28:43",
     "there is no output field 'heat'; there is displacement, force, dilatation, damage, stored_energy, "
     "weighted_volume, stress, strain, von_mises_stress, plastic_work, velocity, fragment, plastic_multiplier and "
     "equivalent_plastic_strain"},
    {"facing_of_a_force", base, "displacement: {z: \"0.3*t\"}", "force: {z: 1}\n    facing: [0, 0, 1]", "24:13",
     "facing chooses faces of the surface and goes with traction or pressure only; remove it"},
    {"facing_nowhere", base, "displacement: {z: \"0.3*t\"}", "traction: {z: 1}\n    facing: [0, 0, 0]", "24:13",
     "facing has length 0 and points nowhere; give a direction"},
    {"field_twice", base, "[displacement, force]", "[force, force]", "28:36",
     "force is named twice in fields; remove one"},
    {"unknown_influence", base, "influence: constant", "influence: Constant", "9:12",
     "influence cannot be 'Constant'; did you mean constant?"},
    {"formula_with_unknown_name", base, "\"z > 6.5\"", "\"zeta > 6.5\"", "19:17",
     "the formula 'zeta > 6.5' cannot be read at character 1: zeta is not known; a formula may use x, y, z, t, pi and "
     "functions such as sin, exp, sqrt"},
    {"formula_with_unknown_function", base, "\"0.3*t\"", "\"0.3*sine(t)\"", "23:23",
     "the formula '0.3*sine(t)' cannot be read at character 5: sine is not known; did you mean sin?"},
    {"formula_with_and", base, "\"z > 6.5\"", "\"z > 6.5 and x < 1\"", "19:17",
     "the formula 'z > 6.5 and x < 1' cannot be read at character 9: 'and' is not an operator; write &&"},
    {"formula_with_or", base, "\"z > 6.5\"", "\"z > 6.5 or x < 1\"", "19:17",
     "the formula 'z > 6.5 or x < 1' cannot be read at character 9: 'or' is not an operator; write ||"},
    {"formula_not_finished", base, "\"0.3*t\"", "\"0.3*\"", "23:23",
     "the formula '0.3*' cannot be read at character 5: it ends too early"},
    {"formula_with_open_parenthesis", base, "\"0.3*t\"", "\"0.3*(t\"", "23:23",
     "the formula '0.3*(t' cannot be read at character 7: a parenthesis is not closed"},
    {"formula_that_assigns", base, "\"z > 6.5\"", "\"z = 6.5\"", "19:17",
     "the formula 'z = 6.5' cannot be read at character 3: write == to compare"},
    {"formula_with_chained_comparison", base, "\"z > 6.5\"", "\"6 < z < 7\"", "19:17",
     "the formula '6 < z < 7' cannot be read at character 7: comparisons cannot be chained; write a < x && x < b"},
    {"formula_with_at_least_turned_round", base, "\"z > 6.5\"", "\"z => 6.5\"", "19:17",
     "the formula 'z => 6.5' cannot be read at character 3: write >= for 'at least'"},
    {"formula_with_semicolon", base, "\"z > 6.5\"", "\"z > 6.5; y > 1\"", "19:17",
     "the formula 'z > 6.5; y > 1' cannot be read at character 8: a formula has no ;: join conditions with && or ||"},
    {"formula_with_comment", base, "\"z > 6.5\"", "\"z > 6.5 # top\"", "19:17",
     "the formula 'z > 6.5 # top' cannot be read at character 9: a formula has no comment: close its quotes before the "
     "#"},
    {"formula_empty", base, "\"0.3*t\"", "\"\"", "23:23",
     "the formula is empty; write a number or a formula of x, y, z and t"},
    {"set_with_time", base, "\"z > 6.5\"", "\"z > 6.5 + t\"", "19:17",
     "the formula of the set head uses t, but a set is the same at every t; use only x, y and z"},
    {"set_without_comparison", base, "\"z > 6.5\"", "\"z - 6.5\"", "19:17",
     "the formula of the set head compares nothing, so that it holds wherever it is not exactly zero; write a "
     "condition, such as \"z - 6.5 > 0\""},
    {"load_on_unknown_set", base, "  - set: head", "  - set: haed", "22:10",
     "haed is not the name of a set or body; did you mean head?"},
    {"history_of_unknown_set", base, "reaction: head", "reaction: top", "30:28",
     "top is not the name of a set or body; there is all, foot, head and block"},
    {"unknown_material", base, "material: steel", "material: stel", "7:15",
     "stel is not the name of a material; did you mean steel?"},
    {"set_of_unknown_body", base, "{where: \"z > 6.5\"}", "{body: blok}", "19:16",
     "blok is not the name of a body; did you mean block?"},
    {"set_named_all", base, "head: {where", "all: {where", "19:8",
     "the set all exists already and means every particle; choose another name"},
    {"set_named_like_a_body", base, "head: {where", "block: {where", "19:10",
     "the set block has the name of a body, for which a set exists already; choose another name"},
    {"body_named_all", base, "name: block", "name: all", "4:11",
     "a body cannot be named all, which means every particle; choose another name"},
    {"two_bodies_of_one_name", base, "horizon: {ratio",
     "  - {name: block, shape: {sphere: {center: [9, 9, 9], radius: 1}}, spacing: 1, material: steel}\nhorizon: {ratio",
     "8:12", "block is already the name of a body (line 4); choose another"},
    {"two_histories_of_one_name", base, "  - {name: pull,", "  - {name: pull, yielded: all}\n  - {name: pull,", "31:12",
     "pull is already the name of a history entry (line 30); choose another"},
    {"history_name_with_comma", base, "name: pull", "name: \"pull, z\"", "30:12",
     "'pull, z' cannot be the name of a history entry; use at most 100 letters, digits, blanks and _ - . +"},
    {"yielded_with_component", base, "reaction: head", "yielded: head", "30:44",
     "the history entry pull is a fraction and has no component; remove it"},
    {"empty_box", base, "max: [4, 4, 8]", "max: [4, 0, 8]", "5:40",
     "max of the box must be greater than min in y, but 0 is not greater than 0"},
    {"empty_set_box", base, "{where: \"z > 6.5\"}", "{box: {min: [0, 0, 7], max: [4, 4, 6]}}", "19:37",
     "max of the box must be greater than min in z, but 6 is not greater than 7"},
    {"point_with_two_entries_in_3d", base, "min: [0, 0, 0]", "min: [0, 0]", "5:24",
     "min needs 3 numbers in a deck with dimension: 3, but has 2"},
    {"point_with_four_entries", base, "min: [0, 0, 0]", "min: [0, 0, 0, 0]", "5:24",
     "min must be a list of 3 numbers, or 2 in 2-D, but has 4"},
    {"point_with_text", base, "min: [0, 0, 0]", "min: [0, a, 0]", "5:28",
     "an entry of min must be a number, but 'a' was found"},
    {"segment_in_3d", base, "horizon:", "cracks: [{segment: {start: [0, 0, 0], end: [1, 0, 0]}}]\nhorizon:", "8:20",
     "a segment cuts only in 2-D; in 3-D write a rectangle or a disc"},
    {"crack_with_parallel_edges", base,
     "horizon:", "cracks:\n  - rectangle: {corner: [0, 0, 0], edge1: [1, 0, 0], edge2: [2, 0, 0]}\nhorizon:", "9:61",
     "edge1 and edge2 of the rectangle must be two different directions, neither zero"},
    {"crack_without_normal", base,
     "horizon:", "cracks:\n  - disc: {center: [0, 0, 0], normal: [0, 0, 0], radius: 1}\nhorizon:", "9:39",
     "normal of the disc is zero; give it a direction"},
    {"no_bodies", flat,
     "body: [{name: plate, shape: {box: {min: [0, 0], max: [4, 4]}}, spacing: 0.5, material: steel}]", "body: []",
     "2:7", "body needs at least 1 entry, but has 0"},
    {"difference_of_one", base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
     "{difference: [{sphere: {center: [0, 0, 0], radius: 1}}]}", "5:25",
     "difference needs at least 2 entries, but has 1"},
    {"error_deep_in_a_shape", base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
     "{union: [{sphere: {center: [0, 0, 0], radius: 0}}]}", "5:58", "radius is 0 but must be greater than 0"},
    {"cylinder_without_length", base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}",
     "{cylinder: {start: [0, 0, 1], end: [0, 0, 1], radius: 1}}", "5:47",
     "start and end of the cylinder are the same point; move one"},
    {"negative_id", base, "{where: \"z > 6.5\"}", "{ids: [1, -2]}", "19:19",
     "an entry of ids is -2 but must be at least 0 and at most 9.0e+18"},
    {"id_twice", base, "{where: \"z > 6.5\"}", "{ids: [1, 1]}", "19:19", "1 is named twice in ids; remove one"},
    {"missing_cloud", base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}", "{file: no_such_cloud.csv}", "5:19",
     "the file no_such_cloud.csv (file) does not exist; relative names start at the deck's folder, so this one was "
     "looked for as "},
    {"missing_table", base, "{x: 0, y: 0, z: 0}", "{table: no_such_table.csv}", "21:39",
     "the file no_such_table.csv (table) does not exist; relative names start at the deck's folder, so this one was "
     "looked for as "},
    {"folder_for_a_cloud", base, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}", "{file: /}", "5:19",
     "/ (file) is a folder; name a file"},
    {"z_displacement_in_2d", flat, "displacement: {x: 0}", "displacement: {z: 0}", "7:42",
     "displacement has a z component, but this deck is 2-D; remove z"},
    {"z_force_in_2d", flat, "displacement: {x: 0}", "body_force: {z: 0}", "7:40",
     "body_force has a z component, but this deck is 2-D; remove z"},
    {"z_history_in_2d", flat, "component: x", "component: z", "8:51",
     "the history entry pull asks for the z component, but this deck is 2-D; use x or y"},
    {"third_entry_in_2d", flat, "min: [0, 0], max: [4, 4]", "min: [0, 0], max: [4, 4, 1]", "2:61",
     "the third entry of max is 1 but must be 0 in 2-D; leave it out"},
    {"rectangle_in_the_plane", flat, "{segment: {start: [1, 1], end: [2, 1]}}",
     "{rectangle: {corner: [1, 1], edge1: [1, 0], edge2: [0, 1]}}", "4:22",
     "this rectangle lies in the plane of the 2-D bodies and cuts no bond; write a segment"},
    {"segment_without_length", flat, "end: [2, 1]", "end: [1, 1]", "4:41",
     "start and end of the segment are the same point; move one"},
};

class MalformedDeck : public ::testing::TestWithParam<Mistake> {};

TEST_P(MalformedDeck, IsRefusedAtItsPlaceWithASentence) {
  const Mistake& mistake = GetParam();
  const std::string yaml = fixture::changed(*mistake.deck, mistake.from, mistake.to);
  EXPECT_THAT(fixture::message_of(yaml),
              ::testing::StartsWith(std::string("deck.yaml:") + mistake.place + ": " + mistake.sentence));
}

INSTANTIATE_TEST_SUITE_P(Deck, MalformedDeck, ::testing::ValuesIn(mistakes),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(MalformedDeck, TheUnchangedDecksRead) {
  EXPECT_EQ(fixture::message_of(*base), "");
  EXPECT_EQ(fixture::message_of(*flat), "");
}

TEST(MalformedDeck, EmptyOrCommentOnly) {
  for (const char* yaml : {"", "\n\n", "# nothing here\n", "~\n"}) {
    EXPECT_EQ(fixture::message_of(yaml),
              "deck.yaml: the deck is empty; it needs at least dimension, body, horizon and materials");
  }
}

TEST(MalformedDeck, AListOrAScalarIsNoDeck) {
  EXPECT_THAT(fixture::message_of("- 1\n- 2\n"), ::testing::StartsWith("deck.yaml:1:1: the deck must be a map"));
  EXPECT_THAT(fixture::message_of("hello\n"), ::testing::HasSubstr("but 'hello' was found"));
}

TEST(MalformedDeck, NestingIsLimited) {
  std::string lists = "title: ";
  for (int i = 0; i < 100; ++i) lists += "[";
  for (int i = 0; i < 100; ++i) lists += "]";
  EXPECT_THAT(fixture::message_of(lists), ::testing::HasSubstr("nested more than 60 deep"));
  EXPECT_THAT(fixture::message_of("title: " + std::string(100000, '[')), ::testing::HasSubstr("nested far too deep"));
  EXPECT_THAT(fixture::message_of("title: &a [*a]\n"), ::testing::HasSubstr("nested more than 60 deep"));
  const std::string formula = std::string(4000, '(') + "t" + std::string(4000, ')');
  EXPECT_THAT(fixture::message_of(fixture::changed(*base, "0.3*t", formula)),
              ::testing::HasSubstr("too many parentheses inside each other"));
}

TEST(MalformedDeck, AliasesThatMultiplyAreLimited) {
  std::string yaml = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    yaml += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 10; ++j) yaml += (j > 0 ? ", " : "") + alias;
    yaml += "]\n";
  }
  EXPECT_THAT(fixture::message_of(yaml), ::testing::HasSubstr("put large data in a file"));
}

TEST(MalformedDeck, MissingFileAndFolder) {
  const auto message = [](const std::string& file) -> std::string {
    try {
      read(file, fixture::schema());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("/no/such/deck.yaml"), "/no/such/deck.yaml: there is no deck of this name; check the path");
  EXPECT_EQ(message("/"), "/: this is a folder; name the deck file in it");
}

}  // namespace
}  // namespace perinox::deck
