#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "output/stretch.hpp"
#include "perinox/output/checksum.hpp"

namespace perinox::output {
namespace {

/// A file of words that no stretch writes, in a directory that goes away.
struct File {
  explicit File(std::size_t words) : all(words, 0xAAAAAAAAAAAAAAAA) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(all.data()), static_cast<std::streamsize>(8 * words));
  }
  ~File() { std::filesystem::remove(path); }
  std::vector<char> read() const {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }
  std::string path = std::filesystem::temp_directory_path() / ("stretch-" + std::to_string(::getpid()));
  std::vector<std::uint64_t> all;
};

/// Small stretches go through the cache, those from 4 MB on bypass it. Their begins and ends lie anywhere in a page.
TEST(Stretch, WritesItsBytesAndNoOthers) {
  const MPI_Comm self = MPI_COMM_SELF;
  for (const std::size_t count : {std::size_t{1}, std::size_t{100}, std::size_t{511}, std::size_t{131072 + 7},
                                  std::size_t{524288}, std::size_t{700001}})
    for (const std::size_t first : {0, 64, 511, 512, 1000}) {
      File file(first + count + 600);
      std::vector<double> values(count);
      for (std::size_t k = 0; k < count; ++k) values[k] = 0.5 + static_cast<double>(k);
      Stretch stretch(file.path, 8 * first, 8 * count, first);
      for (std::size_t k = 0; k < count; k += 999)  // in portions that fit no page
        stretch.append(&values[k], std::min<std::size_t>(999, count - k));
      ASSERT_EQ(stretch.finish(), "");

      std::copy_n(reinterpret_cast<const std::uint64_t*>(values.data()), count,
                  file.all.begin() + static_cast<std::ptrdiff_t>(first));
      const std::vector<char> found = file.read();
      ASSERT_EQ(found.size(), 8 * file.all.size());
      EXPECT_EQ(std::memcmp(found.data(), file.all.data(), found.size()), 0) << count << " from " << first;
      EXPECT_EQ(stretch.checksum(), checksum(values.data(), 8 * count, first));
      // The checksum that the stretch knows stands for its bytes.
      const std::uint64_t end = 8 * file.all.size();
      EXPECT_EQ(
          file_checksum(file.path, 0, end, Communicator(self), {{8 * first, 8 * (first + count), stretch.checksum()}}),
          file_checksum(file.path, 0, end, Communicator(self)));
    }
}

TEST(Stretch, SaysWhyItCannotWrite) {
  Stretch missing("/nowhere/at/all", 0, 8, 0);
  const double value = 1;
  missing.append(&value, 1);
  EXPECT_EQ(missing.finish(), "/nowhere/at/all could not be written: No such file or directory");
  Stretch full("/dev/full", 0, 8, 0);
  full.append(&value, 1);
  EXPECT_EQ(full.finish(), "/dev/full could not be written: No space left on device");
}

}  // namespace
}  // namespace perinox::output
