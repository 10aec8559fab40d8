#include "perinox/output/directory_lock.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <utility>

#include "perinox/core/error.hpp"

namespace perinox::output {

namespace {
namespace fs = std::filesystem;

/// The text that the holder has written; "" if it has not done so yet.
std::string holder_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  std::getline(file, line);
  constexpr std::size_t longest = 1000;
  return line.substr(0, longest);
}

std::string own_description(const std::string& deck) {
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  std::error_code error;
  const fs::path whole = fs::absolute(deck, error).lexically_normal();
  return fmt::format("process {} on {}, which has run {} since {:%Y-%m-%d %H:%M:%S}\n", ::getpid(), host.data(),
                     whole.string(), fmt::localtime(std::time(nullptr)));
}
}  // namespace

DirectoryLock::DirectoryLock(std::string directory, const std::string& deck)
    : directory_(std::move(directory)), path_((fs::path(directory_) / "run.lock").string()) {
  make_directory();
  while (!take()) {
  }
  const std::string text = own_description(deck);
  // A full disk costs the words only, not the lock.
  if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, text.data(), text.size(), 0) < 0) return;
}

DirectoryLock::~DirectoryLock() {
  ::unlink(path_.c_str());
  ::close(file_);
  std::error_code not_empty;
  for (const std::string& directory : made_)
    if (!fs::remove(directory, not_empty)) break;
}

bool DirectoryLock::held(const std::string& directory) {
  const int file = ::open((fs::path(directory) / "run.lock").c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  const bool taken = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return taken;
}

void DirectoryLock::make_directory() {
  std::error_code error;
  for (fs::path missing = fs::absolute(directory_).lexically_normal(); !missing.empty() && !fs::exists(missing, error);
       missing = missing.parent_path())
    if (missing.has_filename()) made_.push_back(missing.string());
  fs::create_directories(directory_, error);
  if (error)
    throw InputError(fmt::format("the output directory {} cannot be used: {}; choose another with --output", directory_,
                                 error.message()));
}

bool DirectoryLock::take() {
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0)
    throw InputError(fmt::format(
        "the output directory {} cannot be written to: choose another with --output or change its permissions",
        directory_));
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    if (reason != EWOULDBLOCK) {
      remark_ = fmt::format("{} cannot be locked ({}): see to it that no other run writes into {}", path_,
                            std::strerror(reason), directory_);
      return true;
    }
    ::close(file_);
    const std::string holder = holder_in(path_);
    throw InputError(fmt::format(
        "the output directory {} is in use by {}: wait for its end, or choose another directory with --output",
        directory_, holder.empty() ? "another process" : holder));
  }
  // The holder before may have removed the file after it was opened here. Others would then lock another file.
  struct stat held {
  }, named{};
  if (::fstat(file_, &held) == 0 && ::stat(path_.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
      held.st_dev == named.st_dev)
    return true;
  ::close(file_);
  return false;
}

}  // namespace perinox::output
