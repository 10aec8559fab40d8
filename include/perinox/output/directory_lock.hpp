#pragma once
#include <string>
#include <vector>

namespace perinox::output {

/// Keeps every other program out of a directory while it lives. It is a lock of the system (flock) on the file
/// `run.lock` in the directory, which says whose it is. The system takes the lock away when the process ends, however
/// it ends, so a file that a killed run has left blocks nobody.
class DirectoryLock {
 public:
  /// Creates the directory and takes the lock. deck: what the process works on, for the sentence that refuses another
  /// one. To be called on one rank only. Throws InputError if the directory is in use (with deck, process and machine
  /// of the holder) or cannot be written to.
  DirectoryLock(std::string directory, const std::string& deck);
  /// Removes the file, and the directories that it has made if nothing was written into them.
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// True if some process holds the lock of a directory.
  static bool held(const std::string& directory);

  /// A sentence to print if the file system has no locks, so that nothing keeps others out; otherwise "".
  const std::string& remark() const { return remark_; }

 private:
  void make_directory();
  /// Returns true once the lock is held on the file that has the name, and false if the file has gone in between.
  bool take();

  std::string directory_, path_, remark_;
  std::vector<std::string> made_;  ///< directories, the innermost first
  int file_ = -1;
};

}  // namespace perinox::output
