#include "run_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "perinox/core/error.hpp"

namespace perinox::output {

namespace {
namespace fs = std::filesystem;

/// All files that a run, or a command on its results, leaves in the directory.
const std::vector<std::string> our_files = {
    "results.h5",  "results.xdmf", "history.csv", "convergence.csv",   "deck.resolved.yaml", "checkpoint.h5",
    "report.html", "picture.png",  "picture.svg", "results.xdmf.part", "checkpoint.h5.part", "results.h5.part"};

/// Moves those of `files` that exist and returns the sentence about it.
std::string move_aside(const fs::path& directory, const std::vector<std::string>& files) {
  fs::path aside;
  std::string first;
  int moved = 0;
  for (const std::string& name : files) {
    if (!fs::exists(directory / name)) continue;
    if (aside.empty()) {
      for (int n = 1; aside.empty() || fs::exists(aside); ++n) aside = directory / fmt::format("previous-{}", n);
      fs::create_directory(aside);
      first = name;
    }
    fs::rename(directory / name, aside / name);
    ++moved;
  }
  if (moved == 0) return "";
  return fmt::format("{} held earlier results: {} moved to {}", directory.string(),
                     moved == 1 ? first + " is" : fmt::format("{} files are", moved), aside.string());
}

void require(const std::string& directory) {
  fs::create_directories(directory);
  if (::access(directory.c_str(), W_OK) != 0)
    throw InputError(fmt::format(
        "the output directory {} cannot be written to: choose another with --output or change its permissions",
        directory));
}

/// Does `work` on rank 0 and returns its result there. If it refuses, every rank throws the refusal.
template <class Work>
std::string on_root(const std::string& directory, const Communicator& communicator, Work&& work) {
  std::string refusal;
  std::string sentence;
  if (communicator.is_root()) try {
      sentence = work();
    } catch (const InputError& error) {
      refusal = error.what();
    } catch (const fs::filesystem_error& error) {
      refusal = fmt::format("the output directory {} cannot be used: {} ({}); choose another with --output", directory,
                            error.code().message(), error.path1().string());
    }
  communicator.agree_on_input_error(refusal);
  return sentence;
}
}  // namespace

std::string prepare_directory(const std::string& directory, const Communicator& communicator) {
  return on_root(directory, communicator, [&] {
    require(directory);
    return move_aside(directory, our_files);
  });
}

void require_directory(const std::string& directory, const Communicator& communicator) {
  on_root(directory, communicator, [&] {
    require(directory);
    return std::string();
  });
}

std::string set_aside(const std::string& directory, const std::string& file, const Communicator& communicator) {
  return on_root(directory, communicator, [&] { return move_aside(directory, {file}); });
}

}  // namespace perinox::output
