/// Each row has one mistake in a point cloud or a displacement table, as in test_malformed.cpp.
#include <ostream>

#include "decks.hpp"
#include "program.hpp"
#include "refusal.hpp"

namespace perinox::cli {
namespace {

struct FileMistake {
  const char* name;
  const char* file;  ///< cloud.csv or field.csv
  const char* from;  ///< empty: the whole file
  const char* to;
  const char* sentence;
};
void PrintTo(const FileMistake& mistake, std::ostream* out) { *out << mistake.name; }

const FileMistake mistakes_in_files[] = {
    {"cloud_empty", "cloud.csv", "", "",
     "{dir}/cloud.csv: the file is empty; a point cloud begins with the header x,y,z,volume"},
    {"cloud_header_only", "cloud.csv", "", "x,y,z,volume\n",
     "{dir}/cloud.csv: the file has a header but no rows; add at least one"},
    {"cloud_without_volumes", "cloud.csv", "", "x,y,z\n0,0,0\n1,0,0\n",
     "{dir}/cloud.csv:1:1: the column volume is missing; a point cloud has the columns x, y, z, volume"},
    {"cloud_with_unknown_column", "cloud.csv", "volume", "volumes",
     "{dir}/cloud.csv:1:7: volumes is not a column of a point cloud, did you mean volume?; the columns are x, y, "
     "z, volume"},
    {"cloud_with_a_word", "cloud.csv", "0,1,0,1", "0,one,0,1", "{dir}/cloud.csv:4:3: one is not a number (column y)"},
    {"cloud_row_too_short", "cloud.csv", "0,1,0,1", "0,1,0",
     "{dir}/cloud.csv:4:6: 3 values in this row, but the header names 4 columns"},
    {"cloud_row_too_long", "cloud.csv", "0,1,0,1", "0,1,0,1,1",
     "{dir}/cloud.csv:4:9: 5 values in this row, but the header names 4 columns"},
    {"cloud_with_an_empty_field", "cloud.csv", "0,1,0,1", "0,,0,1",
     "{dir}/cloud.csv:4:3: an empty field is not a number (column y)"},
    {"cloud_not_a_number", "cloud.csv", "0,1,0,1", "0,nan,0,1",
     "{dir}/cloud.csv:4:3: nan is not a finite number (column y)"},
    {"cloud_separated_by_semicolons", "cloud.csv", "", "x;y;z;volume\n0;0;0;1\n",
     "{dir}/cloud.csv:1:1: x;y;z;volume is not a column of a point cloud; the columns are x, y, z, volume, separated "
     "by "
     "commas"},
    {"mesh_for_a_cloud", "cloud.csv", "", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n",
     "deck.yaml:2:36: the file cloud.csv (file) is a Gmsh mesh, and perinox reads no meshes; what is read here: Point "
     "cloud, a CSV file with the header x,y,z,volume and a row for each particle; a mesh gives one by the centres and "
     "volumes of its elements."},
    {"cloud_of_negative_volume", "cloud.csv", "0,1,0,1", "0,1,0,-1",
     "{dir}/cloud.csv:4:7: the volume of a particle must be greater than 0, but is -1"},
    {"cloud_of_zero_volume", "cloud.csv", "0,1,0,1", "0,1,0,0",
     "{dir}/cloud.csv:4:7: the volume of a particle must be greater than 0, but is 0"},
    {"cloud_with_coincident_points", "cloud.csv", "0,1,0,1", "1,0,0,1",
     "deck.yaml:2:8: particles 1 and 2 are in the same place (1, 0, 0); take one of them out, or move the bodies apart "
     "so that "
     "they do not overlap"},
    {"cloud_with_a_lonely_point", "cloud.csv", "0,1,0,1", "0,50,0,1",
     "deck.yaml:2:8: particle 2 at (0, 50, 0) has no neighbour within the horizon 1.5; make the horizon larger, or "
     "take the "
     "particle out"},
    {"cloud_of_one_point", "cloud.csv", "", "x,y,z,volume\n0,0,0,1\n",
     "deck.yaml:2:8: particle 0 at (0, 0, 0) is the only one, so there is no bond; make the spacing smaller or add "
     "particles"},
    {"table_empty", "field.csv", "", "",
     "{dir}/field.csv: the file is empty; a displacement table begins with the header x,y,z,ux,uy,uz"},
    {"table_without_uz", "field.csv", "", "t,x,y,z,ux,uy\n1,0,0,0,0,0\n",
     "{dir}/field.csv:1:1: the column uz is missing; a displacement table has the columns x, y, z, ux, uy, uz"},
    {"table_with_unknown_column", "field.csv", "ux", "vx",
     "{dir}/field.csv:1:9: vx is not a column of a displacement table, did you mean x?; the columns are t, x, y, "
     "z, ux, uy, uz"},
    {"table_with_a_word", "field.csv", "0.1,0,0\n1,0,1", "much,0,0\n1,0,1",
     "{dir}/field.csv:3:9: much is not a number (column ux)"},
    {"table_row_too_short", "field.csv", "1,1,0,0,0.1,0,0", "1,1,0,0,0.1,0",
     "{dir}/field.csv:3:14: 6 values in this row, but the header names 7 columns"},
    {"table_infinite", "field.csv", "1,1,0,0,0.1,0,0", "1,1,0,0,inf,0,0",
     "{dir}/field.csv:3:9: inf is not a finite number (column ux)"},
    {"table_misses_a_particle", "field.csv", "1,1,0,0,0.1,0,0\n", "",
     "deck.yaml:5:45: {dir}/field.csv has no row for particle 1 at (1, 0, 0) at t = 1; add one, or impose the "
     "table on a smaller set"},
    {"table_misses_a_particle_at_a_later_time", "field.csv", "1,1,1,0,0.1,0,0\n", "1,1,1,0,0.1,0,0\n2,0,0,0,0,0,0\n",
     "deck.yaml:5:45: {dir}/field.csv has no row for particle 1 at (1, 0, 0) at t = 2; add one, or impose the "
     "table on a smaller set"},
    {"table_with_a_point_that_is_no_particle", "field.csv", "1,0,1,0,0,0,0", "1,0,1.5,0,0,0,0",
     "{dir}/field.csv:4:3: no particle is at (0, 1.5, 0); a row is matched to a particle by its reference "
     "position, to 1e-06 of the spacing"},
    {"table_with_a_particle_twice", "field.csv", "1,1,1,0,0.1,0,0\n", "1,1,1,0,0.1,0,0\n1,1,1,0,0.2,0,0\n",
     "{dir}/field.csv:6:1: particle 3 has its displacement at t = 1 on line 5 already; take one of the two rows out"},
    {"table_with_a_negative_time", "field.csv", "1,0,0,0,0,0,0\n", "-1,0,0,0,0,0,0\n",
     "{dir}/field.csv:2:1: t must not be negative, but is -1; the load parameter starts at 0"},
};

class MalformedFile : public ::testing::TestWithParam<FileMistake> {};

TEST_P(MalformedFile, IsRefusedInOneSentence) {
  const FileMistake& mistake = GetParam();
  const bool of_cloud = std::string(mistake.file) == "cloud.csv";
  const std::string text =
      *mistake.from == '\0' ? mistake.to : changed(of_cloud ? cloud : field, mistake.from, mistake.to);
  const Folder folder;
  folder.write("deck.yaml", cloud_deck);
  folder.write("cloud.csv", of_cloud ? text : cloud);
  folder.write("field.csv", of_cloud ? field : text);
  expect_refusal(folder, {"check", "deck.yaml"}, mistake.sentence);
}

INSTANTIATE_TEST_SUITE_P(Cli, MalformedFile, ::testing::ValuesIn(mistakes_in_files),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace perinox::cli
