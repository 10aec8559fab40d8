/// Tests the checkpoint file: what is written comes back, and no file that is damaged or incomplete passes.
#include <cstring>
#include <random>

#include "output/parallel_file.hpp"
#include "perinox/output/checkpoint.hpp"
#include "perinox/output/checksum.hpp"
#include "support/bodies.hpp"
#include "support/restarts.hpp"

namespace perinox::output {
namespace {

using namespace body::fixture;
using ::testing::HasSubstr;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

struct Written {
  Communicator alone{MPI_COMM_SELF};
  test::CheckpointFolder folder{alone};
  body::Body body = build_body(cube(4), alone);
  std::string path = folder.of_step(3);
  std::vector<double> values;

  Written() {
    for (LocalIndex i = 0; i < 2 * body.owned; ++i) values.push_back(0.1 * i);
    CheckpointWriter writer(path, body);
    CheckpointHead head{3, 0.75};
    head.deck = "title: \"a deck\"\n";
    head.history_bytes = 11;
    head.convergence_bytes = 22;
    writer.write(head, [&](StateWriter& to) {
      to.number("a/number", 1.0 / 3);
      to.integer("a/integer", (1LL << 62) + 1);
      to.particles("a/b/field", values.data(), 2);
      to.lists("a/none", std::vector<int>(static_cast<std::size_t>(body.owned), 0), [](const auto&, auto&) {});
    });
  }
  std::string refused() {
    return refusal([&] {
      read_checkpoint_head(path, alone);
      CheckpointReader(path, body).number("a/number");
    });
  }
};

TEST(Checkpoint, WhatIsWrittenComesBack) {
  Written written;
  const CheckpointHead head = read_checkpoint_head(written.path, written.alone);
  EXPECT_EQ(head.step, 3);
  EXPECT_EQ(head.t, 0.75);
  EXPECT_EQ(head.deck, "title: \"a deck\"\n");
  EXPECT_EQ(head.perinox_version, PERINOX_VERSION);
  EXPECT_EQ(head.ranks, 1);
  EXPECT_EQ(head.history_bytes, 11);
  EXPECT_EQ(head.convergence_bytes, 22);
  const CheckpointReader reader(written.path, written.body);
  EXPECT_EQ(reader.number("a/number"), 1.0 / 3);
  EXPECT_EQ(reader.integer("a/integer"), (1LL << 62) + 1);
  EXPECT_EQ(reader.particles("a/b/field", 2), written.values);
  EXPECT_EQ(reader.list_counts("a/none"), std::vector<int>(64, 0));
  EXPECT_TRUE(reader.has("a/number"));
  EXPECT_TRUE(reader.has("a/b/field"));
  EXPECT_FALSE(reader.has("a/c"));
  EXPECT_FALSE(reader.has("b/c/d"));
  EXPECT_THAT(refusal([&] { reader.number("a/nothing"); }), HasSubstr("nothing"));
  EXPECT_FALSE(std::filesystem::exists(written.path + ".part"));
}

TEST(Checkpoint, EveryFlippedBitIsSeen) {
  Written written;
  const std::string whole = bytes_of(written.path);
  std::mt19937 random(7);
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < 512; k += 5) places.push_back(k);
  for (int k = 0; k < 200; ++k) places.push_back(random() % whole.size());
  places.push_back(whole.size() - 1);
  for (const std::size_t place : places) {
    std::string flipped = whole;
    flipped[place] = static_cast<char>(flipped[place] ^ (1 << (random() % 8)));
    std::ofstream(written.path, std::ios::binary) << flipped;
    EXPECT_THAT(written.refused(), HasSubstr(written.path)) << "byte " << place;
  }
  std::ofstream(written.path, std::ios::binary) << whole;
  EXPECT_EQ(written.refused(), "nothing was refused");
}

TEST(Checkpoint, AFileThatIsNotWholeIsRefused) {
  Written written;
  const std::string whole = bytes_of(written.path);
  for (const std::size_t length : {std::size_t{600}, whole.size() / 2, whole.size() - 1}) {
    std::ofstream(written.path, std::ios::binary) << whole.substr(0, length);
    EXPECT_THAT(written.refused(), HasSubstr("is truncated")) << length;
  }
  for (const std::size_t length : {0, 7, 40}) {
    std::ofstream(written.path, std::ios::binary) << whole.substr(0, length);
    EXPECT_THAT(written.refused(), HasSubstr(written.path)) << length;
  }
  std::ofstream(written.path, std::ios::binary) << whole << "more";
  EXPECT_THAT(written.refused(), HasSubstr("is damaged"));
  std::ofstream(written.path, std::ios::binary) << "something else";
  EXPECT_THAT(written.refused(), HasSubstr("is no checkpoint of perinox"));
  std::filesystem::remove(written.path);
  EXPECT_THAT(written.refused(), HasSubstr("No such file"));
}

TEST(Checkpoint, OtherParticlesAreRefused) {
  Written written;
  const body::Body more = build_body(cube(5), written.alone), moved = build_body(cube(4, 1.0 + 1e-12), written.alone);
  EXPECT_THAT(refusal([&] { CheckpointReader(written.path, more); }), HasSubstr("64 particles, the deck makes 125"));
  EXPECT_THAT(refusal([&] { CheckpointReader(written.path, moved); }), HasSubstr("at other places"));
}

TEST(Checkpoint, ADiskThatRefusesLeavesTheOneBefore) {
  Written written;
  const std::string whole = bytes_of(written.path);
  CheckpointWriter writer(written.path, written.body);
  // 8e15 bytes are more than any disk has.
  const auto huge = [&](StateWriter& to) {
    to.lists("a/huge", std::vector<int>(static_cast<std::size_t>(written.body.owned), 2000000000),
             [](const auto&, auto&) { FAIL() << "nothing may be asked for before there is room"; });
    for (int k = 0; k < 8000; ++k) to.particles("a/field", written.values.data(), 2);
  };
  try {
    writer.write({4, 1.0}, huge);
    FAIL() << "there is no such disk";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the checkpoint of step 4 cannot be written"));
  }
  EXPECT_EQ(bytes_of(written.path), whole);
  EXPECT_FALSE(std::filesystem::exists(written.path + ".part"));
}

TEST(Checksum, SharesAddUp) {
  std::string text(1003, 'a');
  for (std::size_t k = 0; k < text.size(); ++k) text[k] = static_cast<char>(k * k);
  const std::uint64_t all = checksum(text.data(), text.size());
  EXPECT_EQ(checksum(text.data(), 400) + checksum(text.data() + 400, 603, 50), all);
  std::string swapped = text;
  std::swap_ranges(swapped.begin(), swapped.begin() + 8, swapped.begin() + 8);
  EXPECT_NE(checksum(swapped.data(), swapped.size()), all);
}

TEST(Checkpoint, ManyNumbersInThePlaceOfOneAreRefused) {
  const Written written;
  {
    ParallelFile file(written.path, written.alone, ParallelFile::Mode::append);
    file.set_attribute("/a", "texts", std::vector<std::string>{"a", "b", "c"});
  }
  // Reading several texts would once have written past the one place for a text and filled the stack behind it.
  const CheckpointReader reader(written.path, written.body);
  EXPECT_THAT(refusal([&] { reader.text("a/texts"); }), HasSubstr("has no text texts at /a"));
}

TEST(Checkpoint, ListsWhoseLengthsDoNotFitAreRefused) {
  const Written written;
  const std::vector<int> negative = [] {
    std::vector<int> all(64, 0);
    all[0] = -1;
    all[1] = 1;
    return all;
  }();
  {
    ParallelFile file(written.path, written.alone, ParallelFile::Mode::append);
    for (const char* name : {"/negative", "/huge"}) file.make_group(name);
    file.write_rows("/negative/count", negative, 64, 0);
    file.make_list("/negative/values", 0);
    file.write_rows("/huge/count", std::vector<int>(64, 2147483647), 64, 0);
    file.make_list("/huge/values", 8);
  }
  const CheckpointReader reader(written.path, written.body);
  for (const char* name : {"negative", "huge"}) {
    EXPECT_THAT(refusal([&] { reader.list_counts(name); }), HasSubstr("do not add up to the")) << name;
    EXPECT_THAT(refusal([&] { reader.lists(name, [](const auto&, const auto&) {}); }),
                HasSubstr("do not add up to the"))
        << name;
  }
}

}  // namespace
}  // namespace perinox::output
