/// Tests point clouds and the reading of CSV files: what is accepted, and where the rest is refused.
#include <limits>

#include "body/cloud.hpp"
#include "perinox/body/csv.hpp"
#include "support/bodies.hpp"

namespace perinox::body {
namespace {

using namespace fixture;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const CsvColumns cloud_columns{"a point cloud", {"x", "y", "z", "volume"}, {}};

CsvTable table_of(const std::string& text) { return CsvTable::from_text(text, "cloud.csv", cloud_columns); }

deck::Deck cloud_deck(const std::string& path, deck::Dimension dimension = deck::Dimension::three) {
  return deck_of(deck::CloudFile{path}, dimension, 0);
}

TEST(Csv, ReadsCommentsBlanksAnyOrderAndWindowsLines) {
  const CsvTable table =
      table_of("\xEF\xBB\xBF# a cloud\r\n\r\n volume , z,y,x\r\n0.5,3,2,1\r\n  # more\n\n+1e-3, -6 ,\t5,.4e1");
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.value(0, table.column("x")), 1);
  EXPECT_EQ(table.value(0, table.column("volume")), 0.5);
  EXPECT_EQ(table.value(1, table.column("x")), 4);
  EXPECT_EQ(table.value(1, table.column("y")), 5);
  EXPECT_EQ(table.value(1, table.column("z")), -6);
  EXPECT_EQ(table.value(1, table.column("volume")), 1e-3);
  EXPECT_EQ(table.line(0), 4);
  EXPECT_EQ(table.line(1), 7);
  EXPECT_EQ(table.where(1, table.column("y")).text(), "cloud.csv:7:13");
  EXPECT_FALSE(table.has("rho"));
}

TEST(Csv, NumbersAreReadToTheLastBit) {
  const CsvTable table = table_of("x,y,z,volume\n0.1,1e308,5e-324,0.30000000000000004\n");
  EXPECT_EQ(table.value(0, 0), 0.1);
  EXPECT_EQ(table.value(0, 1), 1e308);
  EXPECT_EQ(table.value(0, 2), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(table.value(0, 3), 0.1 + 0.2);
}

TEST(Csv, MalformedTextsAreRefusedAtTheirPlace) {
  struct Case {
    const char* text;
    const char* sentence;
  };
  const std::string head = "x,y,z,volume\n";
  const std::vector<Case> cases = {
      {"", "cloud.csv: the file is empty; a point cloud begins with the header x,y,z,volume"},
      {"\n# only a comment\n", "cloud.csv: the file is empty"},
      {"x,y,z,volume\n", "cloud.csv: the file has a header but no rows"},
      {"x,y,z,volume", "cloud.csv: the file has a header but no rows"},
      {"1,2,3,4\n", "cloud.csv:1:1: 1 is not a column of a point cloud"},
      {"x,y,z,volume,rho\n1,2,3,4,5\n", "cloud.csv:1:14: rho is not a column of a point cloud"},
      {"x,y,z,volumn\n1,2,3,4\n", "cloud.csv:1:7: volumn is not a column of a point cloud, did you mean volume?"},
      {"X,y,z,volume\n1,2,3,4\n", "cloud.csv:1:1: X is not a column of a point cloud"},
      {"x;y;z;volume\n1;2;3;4\n", "cloud.csv:1:1: x;y;z;volume is not a column of a point cloud"},
      {"x,y,,volume\n1,2,3,4\n", "cloud.csv:1:5: an empty field is not a column of a point cloud"},
      {"x,y,z,volume,\n1,2,3,4,\n", "cloud.csv:1:14: an empty field is not a column of a point cloud"},
      {"\"x\",y,z,volume\n1,2,3,4\n", "cloud.csv:1:1: \"x\" is not a column of a point cloud"},
      {"# c\nx,y,x,volume\n1,2,3,4\n", "cloud.csv:2:5: the column x is named twice"},
      {"x,y,volume\n1,2,3\n", "cloud.csv:1:1: the column z is missing; a point cloud has the columns x, y, z, volume"},
      {"x,y,z,volume\n1,2,3,4\n1,2,oops,4\n", "cloud.csv:3:5: oops is not a number (column z)"},
      {"x,y,z,volume\n1,2,3,4\n\n# c\n1, 2 3,4,5\n", "cloud.csv:5:4: 2 3 is not a number (column y)"},
      {"x,y,z,volume\n1,2,,4\n", "cloud.csv:2:5: an empty field is not a number (column z)"},
      {"x,y,z,volume\n1,2,3,4mm\n", "cloud.csv:2:7: 4mm is not a number (column volume)"},
      {"x,y,z,volume\n0x10,2,3,4\n", "cloud.csv:2:1: 0x10 is not a number (column x)"},
      {"x,y,z,volume\n+-1,2,3,4\n", "cloud.csv:2:1: +-1 is not a number (column x)"},
      {"x,y,z,volume\n+,2,3,4\n", "cloud.csv:2:1: + is not a number (column x)"},
      {"x,y,z,volume\n--1,2,3,4\n", "cloud.csv:2:1: --1 is not a number (column x)"},
      {"x,y,z,volume\n1,\"2\",3,4\n", "cloud.csv:2:3: \"2\" is not a number (column y)"},
      {"x,y,z,volume\n1,2,3,nan\n", "cloud.csv:2:7: nan is not a finite number (column volume)"},
      {"x,y,z,volume\ninf,2,3,4\n", "cloud.csv:2:1: inf is not a finite number (column x)"},
      {"x,y,z,volume\n1,-Infinity,3,4\n", "cloud.csv:2:3: -Infinity is not a finite number (column y)"},
      {"x,y,z,volume\n1,1e999,3,4\n", "cloud.csv:2:3: 1e999 is too large or too small"},
      {"x,y,z,volume\n1,2,3\n", "cloud.csv:2:6: 3 values in this row, but the header names 4 columns"},
      {"x,y,z,volume\r\n1\r\n", "cloud.csv:2:2: 1 value in this row, but the header names 4 columns"},
      {"x,y,z,volume\n1,2,3,4,5\n", "cloud.csv:2:9: 5 values in this row, but the header names 4 columns"},
      {"x,y,z,volume\n1,2,3,4,\n", "cloud.csv:2:9: 5 values in this row, but the header names 4 columns"},
      {"x,y,z,volume\n1,2,3,\x01\x02\n", "cloud.csv:2:7: ?? is not a number (column volume)"},
      {"x,y,z,volume\n1,2,3,4 # comment\n", "cloud.csv:2:7: 4 # comment is not a number (column volume)"},
  };
  for (const Case& one : cases) {
    EXPECT_THAT(refusal([&] { table_of(one.text); }), StartsWith(one.sentence)) << one.text;
  }
}

TEST(Csv, NulBytesDoNotEndTheReading) {
  const std::string text("x,y,z,volume\n1,2,3\0,4\n", 22);
  EXPECT_THAT(refusal([&] { table_of(text); }), StartsWith("cloud.csv:2:5: 3? is not a number (column z)"));
}

TEST(Cloud, IdsAreRowsAndContinueAfterEarlierBodies) {
  const TextFile file("cloud.csv", "x,y,z,volume\n10,0,0,8\n11,0,0,8\n12,0,0,1\n");
  deck::Deck deck = cube(2);
  add_body(deck, "cloud", deck::CloudFile{file.path()}, 0);
  const Body body = build_body(deck);
  ASSERT_EQ(body.total, 11);
  EXPECT_EQ(body.id[10], 10);
  EXPECT_EQ(body.position3(9), (deck::Point{11, 0, 0}));
  EXPECT_EQ(body.volume[8], 8);
  EXPECT_EQ(body.part[8], 1);
}

TEST(Cloud, SpacingIsTheEdgeOfTheMeanVolumeUnlessGiven) {
  const TextFile file("cloud.csv", "x,y,z,volume\n0,0,0,10\n2,0,0,6\n");
  deck::Deck deck = cloud_deck(file.path());
  EXPECT_DOUBLE_EQ(largest_spacing(deck, Communicator()), 2);
  deck.body[0].spacing = 1.5;
  EXPECT_DOUBLE_EQ(largest_spacing(deck, Communicator()), 1.5);
  deck::Deck flat = cloud_deck(file.path(), deck::Dimension::plane_stress);
  EXPECT_DOUBLE_EQ(largest_spacing(flat, Communicator()), std::sqrt(8.0));
}

TEST(Cloud, ValuesThatMakeNoParticleAreRefusedAtTheirPlace) {
  struct Case {
    deck::Dimension dimension;
    const char* text;
    const char* sentence;
  };
  const auto solid = deck::Dimension::three, flat = deck::Dimension::plane_strain;
  const std::vector<Case> cases = {
      {solid, "x,y,z,volume\n1,2,3,1\n1,2,4,0\n", ":3:7: the volume of a particle must be greater than 0, but is 0"},
      {solid, "volume,x,y,z\n -2,2,3,1\n", ":2:2: the volume of a particle must be greater than 0, but is -2"},
      {solid, "x,y,z,volume\n1,2,3,-0\n", ":2:7: the volume of a particle must be greater than 0, but is -0"},
      {flat, "x,y,z,volume\n1,2,0,1\n1,3,1e-3,1\n", ":3:5: z must be 0 in 2-D, but is 0.001"},
      {solid, "x,y,z,volume\n1,2,3,1\n1,3,abc,1\n", ":3:5: abc is not a number (column z)"},
  };
  for (const Case& one : cases) {
    const TextFile file("bad.csv", one.text);
    EXPECT_THAT(refusal([&] { build_body(cloud_deck(file.path(), one.dimension)); }),
                StartsWith(file.path() + one.sentence));
  }
}

TEST(Cloud, FilesThatCannotBeReadAreRefusedAtTheDeck) {
  EXPECT_THAT(refusal([&] { build_body(cloud_deck("/nowhere/cloud.csv")); }),
              StartsWith("deck.yaml:5:12: cannot read /nowhere/cloud.csv as a point cloud: No such file or directory"));
  EXPECT_THAT(refusal([&] { build_body(cloud_deck("/tmp")); }),
              StartsWith("deck.yaml:5:12: cannot read /tmp as a point cloud: Is a directory"));
}

}  // namespace
}  // namespace perinox::body
