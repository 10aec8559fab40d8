#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string>

namespace perinox::output {

/// Writes one stretch of an existing file, from its beginning on. A large stretch bypasses the system's page cache
/// where the file system lets it: what is written once and read by nobody would push out what others need, and takes
/// three times as long where the pages are new to the machine.
class Stretch {
 public:
  /// offset, bytes: place and length of the stretch in the file. first_word: number of its first 8 bytes for the
  /// checksum.
  Stretch(const std::string& path, std::uint64_t offset, std::uint64_t bytes, std::uint64_t first_word);
  ~Stretch();
  Stretch(const Stretch&) = delete;
  Stretch& operator=(const Stretch&) = delete;

  /// Appends the next `count` numbers. After a failure nothing more is written.
  void append(const double* values, std::size_t count);
  /// Writes what is left. Returns what went wrong, or "".
  std::string finish();
  /// This stretch's share of the file's checksum (checksum.hpp). To be called after finish().
  std::uint64_t checksum() const { return checksum_; }

 private:
  struct Free {
    void operator()(char* memory) const;
  };
  using Buffer = std::unique_ptr<char[], Free>;
  /// Writes what the buffer holds. Large stretches are written while the next buffer fills.
  void flush();
  /// Writes the bytes [from, to) of a buffer that begins at `place` of the file.
  void write_out(const char* buffer, std::uint64_t place, std::size_t from, std::size_t to);
  void write(int file, const char* buffer, std::uint64_t place, std::size_t from, std::size_t to);

  std::string path_;
  int buffered_ = -1, direct_ = -1;
  std::array<Buffer, 2> buffers_;
  int current_ = 0;
  std::uint64_t place_ = 0;  ///< place in the file where the buffer begins; a multiple of a page
  std::size_t from_ = 0;     ///< first byte of the buffer that belongs to this stretch
  std::size_t filled_ = 0;   ///< end of what the buffer holds

  std::future<void> writing_;  ///< while it lasts it owns the three members below
  std::uint64_t next_word_ = 0;
  std::uint64_t checksum_ = 0;
  int failure_ = 0;  ///< errno of the first failure
};

}  // namespace perinox::output
