/// For values of the wrong form, keys of other programs and numbers with units the message says what to write instead.
#include <filesystem>
#include <fstream>
#include <ostream>

#include "deck/fixture.hpp"
#include "deck/history_columns.hpp"

namespace perinox::deck {
namespace {

using fixture::base_deck, fixture::changed, fixture::flat_deck, fixture::message_of;
using ::testing::HasSubstr;
using ::testing::Not;

struct Wrong {
  const char* name;
  const char* from;
  const char* to;
  const char* message;  ///< the whole message behind the file's name
};
void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.from << " -> " << wrong.to; }

const Wrong wrongs[] = {
    // --- another form
    {"number_for_a_test", "{tension: 203.1}", "203.1",
     "16:19: yield_stress must be a map with exactly one of tension or shear, but '203.1' was found; write {tension: "
     "203.1} or {shear: 203.1}"},
    {"number_for_the_horizon", "{ratio: 3.015}", "3.015",
     "8:10: horizon must be a map with exactly one of ratio or length, but '3.015' was found; write {ratio: 3.015} or "
     "{length: 3.015}"},
    {"number_for_components", "displacement: {z: \"0.3*t\"}", "displacement: 0.1",
     "23:19: displacement must be a map with the keys x, y, z and table, but '0.1' was found; write {x: 0.1}, {y: 0.1} "
     "or {z: 0.1}"},
    {"list_for_components", "{x: 0, y: 0, z: 0}", "[0, 0, 1]",
     "21:31: displacement must be a map with the keys x, y, z and table, but a list was found; write {x: 0, y: 0, z: "
     "1}"},
    {"formula_for_a_set", "{where: \"z > 6.5\"}", "\"z > 6.5\"",
     "19:9: sets.head must be a map with exactly one of where, box, ids or body, but 'z > 6.5' was found; write "
     "{where: "
     "\"z > 6.5\"}"},
    {"word_for_a_shape", "shape: {box: {min: [0, 0, 0], max: [4, 4, 8]}}", "shape: box",
     "5:12: shape must be a map with exactly one of box, cylinder, sphere, plate_with_hole, union, difference or file, "
     "but 'box' was found; write {box: {min: ..., max: ...}}"},
    {"model_for_a_material", "    model: elastic-plastic\n", "    model: elastic\n  other: elastic\n  third:\n",
     "14:10: materials.other must be a map with the keys model, density and damage, but 'elastic' was found; write "
     "{model: elastic, ...}"},
    {"list_of_materials", "  steel:\n    model", "  - name: steel\n    model",
     "12:3: materials must be a map from names of your choice, but a list was found; take the hyphens away and write "
     "each entry under its name: NAME: {...}"},
    {"map_for_a_list", "  - name: block\n", "    name: block\n",
     "4:5: body must be a list, but a map was found; begin each entry of the list with a hyphen and a blank"},
    {"word_for_a_list", "fields: [displacement, force]", "fields: force",
     "28:28: fields must be a list, but 'force' was found; write [force]"},
    {"point_without_commas", "[0, 0, 0]", "[0 0 0]",
     "5:24: min must be a list of 3 numbers, or 2 in 2-D, but has 1; write [0, 0, 0]"},
    {"point_without_brackets", "[0, 0, 0]", "0 0 0",
     "5:24: min must be a list of 3 numbers, or 2 in 2-D, but '0 0 0' was found; write [0, 0, 0]"},
    {"point_as_a_map", "[0, 0, 0]", "{x: 0, y: 0, z: 0}",
     "5:24: min must be a list of 3 numbers, or 2 in 2-D, but a map was found; write the coordinates as [0, 0, 0]"},
    {"list_of_one_number", "spacing: 1.0", "spacing: [1.0]",
     "6:14: spacing must be a number, but a list was found; write 1.0 without brackets or hyphen"},
    {"list_of_one_map", "steps: {end: 1.0, count: 20}", "steps:\n  - {end: 1.0, count: 20}",
     "25:3: steps must be a map with the keys end, count, adaptive, max_cuts, time_limit and control, but a list was "
     "found; there is one only: take the hyphen or the brackets away"},
    {"list_for_a_box", "{where: \"z > 6.5\"}", "{box: [0, 0, 6, 4, 4, 8]}",
     "19:15: box must be a map with the keys min and max, but a list was found; write {min: [0, 0, 6], max: [4, 4, "
     "8]}"},
    {"fields_for_the_output", "{every: 1, fields: [displacement, force]}", "[displacement, force]",
     "28:9: output must be a map with the keys every, fields, checkpoint_every and checkpoint_seconds, but a list was "
     "found; write {fields: [displacement, force]}"},
    {"fields_without_brackets", "fields: [displacement, force]", "fields: displacement, force",
     "28:42: force is not a key of output; the entries of a list stand in brackets, as in fields: [displacement, "
     "force]"},
    {"list_for_a_test", "{tension: 203.1}", "[203.1]",
     "16:19: yield_stress must be a map with exactly one of tension or shear, but a list was found; write {tension: "
     "203.1} or {shear: 203.1}"},
    {"two_sets", "  - set: head\n", "  - set: [head, foot]\n",
     "22:10: set must be a text, but a list was found; only one is taken here"},
    {"point_with_semicolons", "[0, 0, 0]", "[0; 0; 0]",
     "5:24: min must be a list of 3 numbers, or 2 in 2-D, but has 1; write [0, 0, 0]"},
    // --- numbers
    {"comment_of_another_language", "bulk_modulus: 160e3", "bulk_modulus: 160e3 // MPa",
     "14:19: bulk_modulus must be a number, but '160e3 // MPa' was found; write 160e3, and # before a comment"},
    {"comma_in_a_formula", "\"0.3*t\"", "\"0,3*t\"",
     "23:23: the formula '0,3*t' cannot be read at character 2: a comma may only separate a function's arguments; "
     "decimals have a point"},
    {"unit", "spacing: 1.0", "spacing: 1.0 mm",
     "6:14: spacing must be a number, but '1.0 mm' was found; write 1.0: a number has no unit here, all are in the one "
     "set of units that the deck is in"},
    {"unit_without_a_blank", "bulk_modulus: 160e3", "bulk_modulus: 160GPa",
     "14:19: bulk_modulus must be a number, but '160GPa' was found; write 160: a number has no unit here, all are in "
     "the one set of units that the deck is in"},
    {"percent", "tolerance: 1e-8", "tolerance: 5%",
     "27:23: tolerance must be a number, but '5%' was found; write 0.05"},
    {"fraction", "spacing: 1.0", "spacing: 1/4",
     "6:14: spacing must be a number, but '1/4' was found; formulas are read in loads and sets only, so write 0.25"},
    {"thousands_with_a_comma", "bulk_modulus: 160e3", "bulk_modulus: 160,000",
     "14:19: bulk_modulus must be a number, but '160,000' was found; write 160000, or 160.000 if the comma is a "
     "decimal "
     "one"},
    {"thousands_with_blanks", "bulk_modulus: 160e3", "bulk_modulus: 1 600 000",
     "14:19: bulk_modulus must be a number, but '1 600 000' was found; write 1600000"},
    {"yes", "count: 20", "adaptive: yes", "24:29: adaptive must be true or false, but 'yes' was found; write true"},
    // --- keys
    {"thickness", "    spacing: 1.0", "    thickness: 2",
     "6:5: thickness is not a key of a body; 2-D bodies have thickness 1: forces, reactions and energies are per unit "
     "thickness, so divide given forces by the thickness"},
    {"gravity", "influence: constant", "gravity: 9.81",
     "9:1: gravity is not a key of a deck; give it as a load, boundary: - {set: all, body_force: {...}}, density times "
     "acceleration"},
    {"symbol_for_a_modulus", "bulk_modulus: 160e3", "E: 210e3",
     "14:5: E is not a key of a material; did you mean young_modulus?"},
    {"key_of_another_part", "influence: constant", "max_cuts: 3",
     "9:1: max_cuts is not a key of a deck; it belongs elsewhere, as steps.max_cuts"},
    {"key_of_the_deck", "horizon: {ratio: 3.015}\ninfluence: constant",
     "horizon:\n  ratio: 3.015\n  influence: constant",
     "10:3: influence is not a key of horizon; it is a key of the deck itself, so let it begin in the first column"},
    {"force_in_the_history", "reaction: head", "force: head",
     "30:18: force is not a key of a history entry; did you mean reaction?"},
    {"key_not_indented", "steps: {end: 1.0, count: 20}", "steps:\nend: 1.0",
     "25:1: end is not a key of a deck; if it belongs into steps above it, indent it further"},
    {"column_of_the_history", "name: pull", "name: t",
     "30:12: history.csv has a column t of its own; give this entry another name, such as t_of_set"},
    {"column_of_some_histories", "name: pull", "name: broken_bonds",
     "30:12: history.csv has a column broken_bonds of its own; give this entry another name, such as "
     "broken_bonds_of_set"},
    // --- output fields
    {"field_of_another_dimension", "[displacement, force]", "[plastic_strain]",
     "28:29: there is no output field 'plastic_strain'; did you mean equivalent_plastic_strain?"},
    {"field_of_another_name", "[displacement, force]", "[strain_energy]",
     "28:29: there is no output field 'strain_energy'; did you mean stored_energy?"},
    {"field_by_a_part_of_its_name", "[displacement, force]", "[mises]",
     "28:29: there is no output field 'mises'; did you mean von_mises_stress?"},
};

class WrongInput : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongInput, IsToldWhatToWrite) {
  const Wrong& wrong = GetParam();
  EXPECT_EQ(message_of(changed(base_deck, wrong.from, wrong.to)), std::string("deck.yaml:") + wrong.message);
}

INSTANTIATE_TEST_SUITE_P(Deck, WrongInput, ::testing::ValuesIn(wrongs),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Remedies, InThePlaneTheFieldOutOfItIsSuggested) {
  const std::string deck = changed(flat_deck, "history:", "output: {fields: [plastic_strain]}\nhistory:");
  EXPECT_EQ(message_of(deck),
            "deck.yaml:8:19: there is no output field 'plastic_strain'; did you mean plastic_strain_zz?");
}

TEST(Remedies, EveryColumnOfTheHistoryIsTaken) {
  for (const std::string& column : history_columns)
    EXPECT_THAT(message_of(changed(base_deck, "name: pull", "name: " + column)), HasSubstr("has a column " + column));
}

/// A mesh is recognised by its first bytes or its name. A table is one under any name.
TEST(Remedies, AMeshIsCalledAMesh) {
  const auto folder = std::filesystem::temp_directory_path() / "perinox_test_mesh";
  std::filesystem::create_directories(folder);
  const auto message = [&](const std::string& name, const std::string& content) {
    const std::string path = (folder / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return message_of(changed(base_deck, "{box: {min: [0, 0, 0], max: [4, 4, 8]}}", "{file: " + path + "}"));
  };
  const std::string netcdf("CDF\x02\0\0\0\0\0\0\0\n", 12);
  for (const auto& [name, content, kind] :
       std::vector<std::array<std::string, 3>>{{"part.g", netcdf, "an Exodus or NetCDF mesh"},
                                               {"part.csv", netcdf, "an Exodus or NetCDF mesh"},
                                               {"part.e", "\x89HDF\r\n\x1a\n", "an Exodus or HDF5 file"},
                                               {"plate.msh", "$MeshFormat\n4.1 0 8\n", "a Gmsh mesh"},
                                               {"plate.inp", "*Heading\n*Node\n1, 0, 0, 0\n", "an Abaqus mesh"},
                                               {"plate.INP", "** made by hand\n*Node\n", "an Abaqus mesh"},
                                               {"part.stl", "solid part\nfacet normal 0 0 1\n", "an STL surface"},
                                               {"binary.stl", std::string(100, '\0'), "an STL surface"},
                                               {"part.vtk", "# vtk DataFile Version 3.0\n", "a VTK mesh"},
                                               {"part.vtu", "<VTKFile type=\"UnstructuredGrid\">\n", "a VTK mesh"},
                                               {"part.step", "ISO-10303-21;\n", "a STEP geometry"}}) {
    EXPECT_THAT(message(name, content),
                HasSubstr("/" + name + " (file) is " + kind +
                          ", and perinox reads no meshes; what "
                          "is read here: Point cloud, a CSV file with the header x,y,z,volume"));
    EXPECT_THAT(message(name, content), ::testing::StartsWith("deck.yaml:5:19: the file "));
  }
  EXPECT_THAT(message("cloud.g", "x,y,z,volume\n0,0,0,1\n"), Not(HasSubstr("mesh")));
  EXPECT_THAT(message("cloud.csv", "# a comment\nx,y,z,volume\n0,0,0,1\n"), Not(HasSubstr("mesh")));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace perinox::deck
