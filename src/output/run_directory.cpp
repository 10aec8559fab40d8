#include "perinox/output/run_directory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <filesystem>

#include "perinox/core/error.hpp"

namespace perinox::output {

namespace {
namespace fs = std::filesystem;

/// Every file a run, or a command on its results, leaves in the directory.
constexpr std::array<const char*, 10> our_files = {
    "results.h5",    "results.xdmf", "history.csv", "convergence.csv", "deck.resolved.yaml",
    "checkpoint.h5", "report.html",  "picture.png", "picture.svg",     "results.xdmf.part"};

/// Moves what is there; returns the sentence about it.
std::string move_aside(const fs::path& directory) {
  fs::path aside;
  std::string first;
  int moved = 0;
  for (const char* name : our_files) {
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

std::string prepare(const std::string& directory) {
  try {
    fs::create_directories(directory);
    if (::access(directory.c_str(), W_OK) != 0)
      throw InputError(fmt::format(
          "the output directory {} cannot be written to: choose another with --output or change its permissions",
          directory));
    return move_aside(directory);
  } catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("the output directory {} cannot be used: {} ({}); choose another with --output",
                                 directory, error.code().message(), error.path1().string()));
  }
}
}  // namespace

std::string prepare_directory(const std::string& directory, const Communicator& communicator) {
  std::string refusal;
  std::string sentence;
  if (communicator.is_root()) try {
      sentence = prepare(directory);
    } catch (const InputError& error) {
      refusal = error.what();
    }
  communicator.agree_on_input_error(refusal);
  return sentence;
}

}  // namespace perinox::output
