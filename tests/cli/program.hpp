#pragma once
/// Runs the perinox binary as a user starts it: in a folder of its own, with its exit status and everything it says.
/// This test program itself uses no MPI, so that mpirun can be started from it.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace perinox::cli {

inline std::string read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  return text.str();
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// `text` with the first `from` replaced. The test fails if there is none.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "the text has no " << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

struct Outcome {
  int status = -1;  ///< exit status; 128 + number if ended by a signal
  std::string out, error;
};

/// An empty folder under the system's temporary one. It is gone when the test ends.
class Folder {
 public:
  Folder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "perinox_cli_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = std::filesystem::canonical(pattern);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  /// Names in the folder, sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
      all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Runs `program` in the folder and waits for it. Ends it after `seconds`.
  Outcome run(const std::string& program, const std::vector<std::string>& arguments, int seconds = 300) const {
    const Folder said;
    const std::string out = said.path_ / "out", error = said.path_ / "error";
    const pid_t child = fork();
    if (child == 0) start(program, arguments, out, error);
    Outcome outcome;
    if (child < 0) return outcome;
    int status = 0;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (waitpid(child, &status, WNOHANG) == 0) {
      if (std::chrono::steady_clock::now() > end) {
        kill(child, SIGKILL);
        ADD_FAILURE() << program << " was ended after " << seconds << " s";
        waitpid(child, &status, 0);
        break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.out = read(out);
    outcome.error = read(error);
    return outcome;
  }
  Outcome perinox(const std::vector<std::string>& arguments) const { return run(PERINOX_BINARY, arguments); }
  Outcome perinox_on_ranks(int ranks, std::vector<std::string> arguments) const {
    std::vector<std::string> all{"--oversubscribe", PERINOX_MPI_COUNT_FLAG, std::to_string(ranks), PERINOX_BINARY};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(PERINOX_MPIEXEC, all);
  }

 private:
  [[noreturn]] void start(const std::string& program, const std::vector<std::string>& arguments, const std::string& out,
                          const std::string& error) const {
    const int out_file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int error_file = open(error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out_file, STDOUT_FILENO);
    dup2(error_file, STDERR_FILENO);
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    if (chdir(path_.c_str()) == 0) execv(program.c_str(), pointers.data());
    _exit(127);
  }

  std::filesystem::path path_;
};

}  // namespace perinox::cli
