#include "perinox/output/checksum.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "agree.hpp"

namespace perinox::output {

namespace {

constexpr std::uint64_t step = 0x9e3779b97f4a7c15;
constexpr std::size_t word_bytes = 8;
constexpr std::size_t buffer_bytes = std::size_t{4} << 20;

std::uint64_t mix(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9;
  word = (word ^ (word >> 27)) * 0x94d049bb133111eb;
  return word ^ (word >> 31);
}

/// Adds the checksum of [begin, end) to `sum`. Returns the failure as a sentence, or "".
std::string add_share(const std::string& path, std::uint64_t begin, std::uint64_t end, std::uint64_t first_word,
                      std::uint64_t& sum) {
  const int file = ::open(path.c_str(), O_RDONLY);
  if (file < 0) return fmt::format("{} cannot be read: {}", path, std::strerror(errno));
  std::vector<char> buffer(static_cast<std::size_t>(std::min<std::uint64_t>(end - begin, buffer_bytes)));
  std::string failure;
  while (begin < end && failure.empty()) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(end - begin, buffer_bytes));
    std::size_t got = 0;
    while (got < wanted) {
      const ssize_t now = ::pread(file, buffer.data() + got, wanted - got, static_cast<off_t>(begin + got));
      if (now < 0 && errno == EINTR) continue;
      if (now <= 0) break;
      got += static_cast<std::size_t>(now);
    }
    if (got < wanted) failure = fmt::format("{} could not be read to its end", path);
    sum += checksum(buffer.data(), got, first_word);
    begin += wanted;
    first_word += wanted / word_bytes;
  }
  ::close(file);
  return failure;
}

}  // namespace

std::uint64_t checksum(const void* data, std::size_t bytes, std::uint64_t first_word) {
  const auto* from = static_cast<const char*>(data);
  std::uint64_t sum = 0, word = 0, salt = step * (first_word + 1);
  std::size_t at = 0;
  for (; at + word_bytes <= bytes; at += word_bytes, salt += step) {
    std::memcpy(&word, from + at, word_bytes);
    sum += mix(word + salt);
  }
  if (at == bytes) return sum;
  word = 0;
  std::memcpy(&word, from + at, bytes - at);
  return sum + mix(word + salt);
}

std::uint64_t file_checksum(const std::string& path, std::uint64_t begin, std::uint64_t end,
                            const Communicator& communicator, const std::vector<KnownShare>& known) {
  const auto rank = static_cast<std::uint64_t>(communicator.rank()),
             ranks = static_cast<std::uint64_t>(communicator.size());
  std::uint64_t sum = 0, from = begin;
  std::string failure;
  const auto add = [&](std::uint64_t to) {
    const std::uint64_t words = (to - from + word_bytes - 1) / word_bytes;
    const std::uint64_t first = words / ranks * rank + std::min(rank, words % ranks);
    const std::uint64_t last = first + words / ranks + (rank < words % ranks ? 1 : 0);
    if (first < last && failure.empty())
      failure = add_share(path, from + first * word_bytes, std::min(to, from + last * word_bytes),
                          (from - begin) / word_bytes + first, sum);
  };
  for (const KnownShare& share : known) {
    add(share.begin);
    sum += share.checksum;
    from = share.end;
  }
  add(end);
  agree_on_run_error(communicator, failure);
  MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_UINT64_T, MPI_SUM, communicator.mpi());
  return sum;
}

std::string hexadecimal(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace perinox::output
