#include "stretch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>

#include "perinox/output/checksum.hpp"

namespace perinox::output {

namespace {
/// Direct input and output needs addresses, offsets and lengths that are multiples of the disk's blocks. A page is such
/// a multiple.
constexpr std::size_t page = 4096, buffer_bytes = 256 * page;
/// Below this size a transfer of its own costs more than the cache.
constexpr std::uint64_t direct_from = 4 * buffer_bytes;
}  // namespace

void Stretch::Free::operator()(char* memory) const { std::free(memory); }

Stretch::Stretch(const std::string& path, std::uint64_t offset, std::uint64_t bytes, std::uint64_t first_word)
    : path_(path), place_(offset / page * page), from_(offset % page), filled_(from_), next_word_(first_word) {
  if (bytes == 0) return;
  buffered_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (buffered_ < 0) failure_ = errno;
  if (bytes >= direct_from) direct_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_DIRECT);
  for (int k = 0; k < (bytes >= direct_from ? 2 : 1); ++k) {
    buffers_[k].reset(static_cast<char*>(std::aligned_alloc(page, buffer_bytes)));
    if (!buffers_[k]) throw std::bad_alloc();
  }
}

Stretch::~Stretch() {
  if (writing_.valid()) writing_.wait();
  if (buffered_ >= 0) ::close(buffered_);
  if (direct_ >= 0) ::close(direct_);
}

void Stretch::append(const double* values, std::size_t count) {
  const auto* next = reinterpret_cast<const char*>(values);
  for (std::size_t left = count * sizeof(double); left > 0;) {
    const std::size_t taken = std::min(left, buffer_bytes - filled_);
    std::memcpy(buffers_[current_].get() + filled_, next, taken);
    next += taken;
    left -= taken;
    filled_ += taken;
    if (filled_ == buffer_bytes) flush();
  }
}

std::string Stretch::finish() {
  if (filled_ > from_) flush();
  if (writing_.valid()) writing_.get();
  return failure_ == 0 ? "" : fmt::format("{} could not be written: {}", path_, std::strerror(failure_));
}

void Stretch::flush() {
  if (writing_.valid()) writing_.get();
  const char* const full = buffers_[current_].get();
  const auto job = [this, full, place = place_, from = from_, to = filled_] { write_out(full, place, from, to); };
  if (buffers_[1]) {
    writing_ = std::async(std::launch::async, job);
    current_ = 1 - current_;
  } else {
    job();
  }
  place_ += buffer_bytes;
  from_ = filled_ = 0;
}

void Stretch::write_out(const char* buffer, std::uint64_t place, std::size_t from, std::size_t to) {
  checksum_ += output::checksum(buffer + from, to - from, next_word_);
  next_word_ += (to - from) / sizeof(double);
  // Whole pages that belong to this stretch alone are written directly. A page that it shares belongs to others too.
  const std::size_t first = std::min(to, (from + page - 1) / page * page), last = std::max(first, to / page * page);
  write(buffered_, buffer, place, from, first);
  if (last > first && direct_ >= 0) {
    write(direct_, buffer, place, first, last);
    if (failure_ == EINVAL) {  // the file system will not have it after all
      failure_ = 0;
      ::close(direct_);
      direct_ = -1;
    }
  }
  if (direct_ < 0) write(buffered_, buffer, place, first, last);
  write(buffered_, buffer, place, last, to);
}

void Stretch::write(int file, const char* buffer, std::uint64_t place, std::size_t from, std::size_t to) {
  while (failure_ == 0 && from < to) {
    const ssize_t written = ::pwrite(file, buffer + from, to - from, static_cast<off_t>(place + from));
    if (written > 0)
      from += static_cast<std::size_t>(written);
    else if (written == 0 || errno != EINTR)
      failure_ = written == 0 ? EIO : errno;
  }
}

}  // namespace perinox::output
