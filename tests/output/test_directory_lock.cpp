/// Tests that one run has a directory to itself.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "perinox/core/error.hpp"
#include "perinox/output/directory_lock.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {
namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// The sentence that refuses a lock; "" if the lock can be had.
std::string refusal_of(const std::string& directory) {
  try {
    const DirectoryLock lock(directory, "second.yaml");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(DirectoryLock, KeepsOthersOutAndSaysWhoseItIs) {
  const test::TemporaryDirectory directory;
  {
    const DirectoryLock lock(directory.path(), "inputs/first.yaml");
    EXPECT_EQ(lock.remark(), "");
    EXPECT_TRUE(DirectoryLock::held(directory.path()));
    EXPECT_THAT(refusal_of(directory.path()),
                AllOf(HasSubstr(directory.path() + " is in use by process " + std::to_string(::getpid()) + " on "),
                      HasSubstr(fs::absolute("inputs/first.yaml").string()),
                      HasSubstr("choose another directory with --output")));
  }
  EXPECT_FALSE(DirectoryLock::held(directory.path()));
  EXPECT_EQ(refusal_of(directory.path()), "");
  EXPECT_FALSE(fs::exists(directory / "run.lock"));
}

TEST(DirectoryLock, WhatAKilledHolderLeavesBlocksNobody) {
  const test::TemporaryDirectory directory;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const DirectoryLock lock(directory.path(), "killed.yaml");
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(1);
  }
  char one = 0;
  ASSERT_EQ(::read(ready[0], &one, 1), 1);
  EXPECT_THAT(refusal_of(directory.path()), HasSubstr("is in use by process " + std::to_string(child)));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(directory / "run.lock"));
  EXPECT_EQ(refusal_of(directory.path()), "");
  for (const int end : ready) ::close(end);
}

TEST(DirectoryLock, LeavesNoDirectoryInWhichNothingWasWritten) {
  const test::TemporaryDirectory directory;
  { const DirectoryLock lock(directory / "deep/inside", "deck.yaml"); }
  EXPECT_FALSE(fs::exists(directory / "deep"));
  EXPECT_TRUE(fs::exists(directory.path()));
  {
    const DirectoryLock lock(directory / "deep/inside", "deck.yaml");
    std::ofstream(directory / "deep/file") << "mine";
  }
  EXPECT_FALSE(fs::exists(directory / "deep/inside"));
  EXPECT_TRUE(fs::exists(directory / "deep/file"));
  { const DirectoryLock lock(directory / "deep", "deck.yaml"); }
  EXPECT_TRUE(fs::exists(directory / "deep/file"));
}

TEST(DirectoryLock, RefusesADirectoryThatCannotBe) {
  const test::TemporaryDirectory directory;
  std::ofstream(directory / "file") << "in the way";
  EXPECT_THAT(refusal_of(directory / "file"),
              HasSubstr("the output directory " + directory.path() + "/file cannot be"));
  EXPECT_THAT(refusal_of(directory / "file/below"), HasSubstr("choose another with --output"));
}

}  // namespace
}  // namespace perinox::output
