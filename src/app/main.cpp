/// perinox: the commands of docs/commands.md. Exit status: 0 done; 1 the run stopped short; 2 the input is wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "perinox/app/commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/study/child_process.hpp"

namespace {

void say(bool is_root, const char* prefix, const std::string& sentence) {
  std::fflush(stdout);
  if (is_root) fmt::print(stderr, "{}{}\n", prefix, sentence);
}

/// `ranks` is missing where MPI is not up: for the command study, whose runs are MPI programs of their own.
int command_line(int argc, char** argv, const perinox::Communicator* ranks, bool is_root) {
  using namespace perinox;
  app::Options options;
  std::string key;
  bool page = false, json_schema = false, study_keys = false;
  study::Request request;

  CLI::App cli{"Implicit quasi-static nonlinear peridynamics on Trilinos", "perinox"};
  cli.set_version_flag("--version", "perinox " PERINOX_VERSION);
  cli.require_subcommand(1);
  cli.footer("Example: mpirun -np 2 perinox run inputs/tension_block.yaml --output results/tension_block");
  auto* run = cli.add_subcommand("run", "solve a deck's load path; under mpirun on N ranks");
  auto* check =
      cli.add_subcommand("check", "validate a deck; print the scene, the resolved deck and what it costs; run nothing");
  auto* verify =
      cli.add_subcommand("verify", "tangent against central differences and symmetry at the scene's own states");
  auto* help = cli.add_subcommand("help", "documentation of a deck key, from the schema");
  auto* study =
      cli.add_subcommand("study", "run a deck over swept parameters; errors, costs, plots and a page of them");
  for (auto* command : {run, check, verify}) {
    command->add_option("DECK", options.deck, "the deck, a YAML file")->required();
    command->add_option("--set", options.overrides, "override one value: key.path=value; may be given again")
        ->take_all()
        ->allow_extra_args(false);
    command->add_flag("--quiet", options.quiet, "print nothing but warnings and errors");
  }
  run->add_option("--output", options.output, "directory for the results (default: results/<deck's name>)");
  run->add_option("--restart", options.restart,
                  "go on from a checkpoint, DIR/checkpoint.h5, on any number of ranks; without --output in DIR itself");
  study->add_option("STUDY", request.file, "the study, a YAML file")->required();
  study->add_option("--output", request.output, "directory for everything (default: results/studies/<study's name>)");
  study->add_flag("--again", request.again, "repeat runs that are finished");
  study->add_flag("--plan", request.plan, "check the study and its decks, list the runs, run nothing");
  study->add_flag("--quiet", request.quiet, "print nothing but errors");
  help->add_option("KEY", key, "a key's dotted path or its last name");
  help->add_flag("--page", page, "print the whole reference page, docs/deck.md");
  help->add_flag("--json-schema", json_schema, "print the deck's JSON Schema for editors");
  help->add_flag("--study", study_keys, "print the table of a study's keys");

  const std::vector<std::string> commands{"run", "check", "verify", "study", "help"};
  if (argc > 1 && argv[1][0] != '-' && std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
    const std::string hint = deck::nearest(argv[1], commands);
    say(is_root, "perinox: ",
        fmt::format("{} is not a command{}; perinox --help lists the commands", argv[1],
                    hint.empty() ? "" : ", did you mean " + hint + "?"));
    return 2;
  }
  try {
    cli.parse(argc, argv);
  } catch (const CLI::Success& message) {  // --help, --version
    if (is_root) cli.exit(message);
    return 0;
  } catch (const CLI::ParseError& error) {
    say(is_root, "perinox: ", std::string(error.what()) + "; perinox --help lists the commands");
    return 2;
  }
  if (study->parsed() || ranks == nullptr) return app::study(request);
  if (run->parsed()) return app::run(options, *ranks);
  if (check->parsed()) return app::check(options, *ranks);
  if (verify->parsed()) return app::verify(options, *ranks);
  if (study_keys) return app::study_keys(*ranks);
  return app::help(key, page, json_schema, *ranks);
}

/// A process started without mpirun talks to itself only. Two thirds of its start is what Open MPI brings up for
/// others: networks, and a daemon for MPI_Comm_spawn. Without the daemon all such runs of a user would share one folder
/// in /tmp, which the first to end takes away from the rest; so each has its own.
class StartAlone {
 public:
  StartAlone() {
    for (const char* launched : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"})
      if (std::getenv(launched) != nullptr) return;
    std::error_code none;
    std::string folder = (std::filesystem::temp_directory_path(none) / "perinox-XXXXXX").string();
    if (none || mkdtemp(folder.data()) == nullptr) return;
    folder_ = folder;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
    setenv("OMPI_MCA_orte_tmpdir_base", folder_.c_str(), 1);
    setenv("OMPI_MCA_pml", "ob1", 1);  // in place of what is set for runs on many machines, too
    setenv("OMPI_MCA_btl", "self", 1);
  }
  StartAlone(const StartAlone&) = delete;
  StartAlone& operator=(const StartAlone&) = delete;
  ~StartAlone() {
    std::error_code ignored;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
  }

 private:
  std::string folder_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && argv[1] == std::string("study")) {
    // Under mpirun the first rank refuses for all; another that failed before it would have it ended unheard.
    if (!perinox::study::first_rank_around()) return 0;
    try {
      return command_line(argc, argv, nullptr, true);
    } catch (const perinox::InputError& error) {
      say(true, "", error.what());
      return 2;
    } catch (const std::exception& error) {
      say(true, "perinox: ", error.what());
      return 1;
    }
  }
  const StartAlone alone;
  // Kokkos takes --help and other options for its own: it is shown the program's name alone.
  int shown = 1;
  char* name_only[] = {argv[0], nullptr};
  char** names = name_only;
  const Tpetra::ScopeGuard guard(&shown, &names);
  const perinox::Communicator ranks;
  try {
    return command_line(argc, argv, &ranks, ranks.is_root());
  } catch (const perinox::InputError& error) {
    say(ranks.is_root(), "", error.what());
    return 2;
  } catch (const perinox::RunError& error) {
    say(ranks.is_root(), "perinox: ", error.what());
    return 1;
  } catch (const std::exception& error) {
    // Not agreed on by the ranks: the others may be waiting for this one, so all are ended.
    fmt::print(stderr, "perinox: rank {}: {}\n", ranks.rank(), error.what());
    std::fflush(stderr);
    if (ranks.size() > 1) MPI_Abort(ranks.mpi(), 1);
    return 1;
  }
}
