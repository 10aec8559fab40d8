#include "reserve.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace perinox::output {

std::string reserve(const std::string& path, double bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0666);
  if (file < 0) return fmt::format("{} cannot be opened: {}", path, std::strerror(errno));
  struct stat now {};
  ::fstat(file, &now);
  const int failure = ::posix_fallocate(file, now.st_size, static_cast<off_t>(bytes));
  if (failure != 0) (void)!::ftruncate(file, now.st_size);
  ::close(file);
  if (failure == 0) return "";
  return fmt::format("{} is left as it is: {:.2g} MB more cannot be written: {}", path, bytes / 1e6,
                     std::strerror(failure));
}

std::string sync_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY);
  // Some file systems cannot do this for a directory, or not at all.
  const bool done = file >= 0 && (::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP);
  const std::string reason = done ? "" : std::strerror(errno);
  if (file >= 0) ::close(file);
  return reason;
}

}  // namespace perinox::output
