/// The program perinox: the commands of docs/commands.md. Exit status: 0 done; 1 the run stopped short; 2 the input is
/// wrong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Tpetra_Core.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "commands.hpp"
#include "perinox/core/error.hpp"
#include "perinox/deck/read.hpp"
#include "perinox/study/child_process.hpp"

namespace {

void say(bool is_root, const char* prefix, const std::string& sentence) {
  std::fflush(stdout);
  if (is_root) fmt::print(stderr, "{}{}\n", prefix, sentence);
}

const std::vector<std::string> commands{"run", "check", "verify", "study", "help"};

/// Adds the text below a command's options: lines that can be typed in the program's folder, and what they do.
void give_examples(CLI::App& cli) {
  cli.footer(
      "perinox COMMAND --help tells more of one command, perinox help KEY of a deck's key.\n"
      "Example: perinox run inputs/tension_block.yaml");
  cli.get_subcommand("run")->footer(
      "Examples:\n"
      "  perinox run inputs/tension_block.yaml\n"
      "      results in results/tension_block\n"
      "  mpirun -np 2 perinox run inputs/tension_block.yaml --output results/on_two --set steps.count=20\n"
      "      on two ranks, to another folder, with one value of the deck replaced\n"
      "  perinox run inputs/tension_block.yaml --restart results/tension_block/checkpoint.h5\n"
      "      goes on from where a run stopped\n"
      "Exit status: 0 done; 1 the run stopped short, what it has is on disk; 2 the input is wrong");
  cli.get_subcommand("check")->footer(
      "Examples:\n"
      "  perinox check inputs/tension_block.yaml\n"
      "  perinox check inputs/tension_block.yaml --set body.0.spacing=0.5\n"
      "      particles, memory and cost of a finer lattice\n"
      "  perinox check inputs/tension_block.yaml --quiet && echo valid\n"
      "Exit status: 0 the deck is valid; 2 it is not");
  cli.get_subcommand("verify")->footer(
      "Examples:\n"
      "  perinox verify inputs/shear_cube.yaml\n"
      "  perinox verify inputs/shear_cube.yaml --set solver.form=printed\n"
      "      with the tangent as the literature prints it, which does not hold\n"
      "Exit status: 0 the tangent holds; 1 it does not; 2 the input is wrong");
  cli.get_subcommand("study")->footer(
      "Examples:\n"
      "  perinox study studies/newton.yaml --plan\n"
      "      which runs it would make\n"
      "  perinox study studies/newton.yaml\n"
      "      results in results/studies/newton; started again it goes on where it was\n"
      "  perinox help --study\n"
      "      the keys of a study\n"
      "Exit status: 0 done; 1 a run stopped short or could not be measured; 2 the input is wrong");
  cli.get_subcommand("help")->footer(
      "Examples:\n"
      "  perinox help\n"
      "      the deck's keys\n"
      "  perinox help boundary\n"
      "  perinox help solver.newton.tolerance\n"
      "  perinox help von_mises_stress\n"
      "      an output field\n"
      "  perinox help run\n"
      "      a command");
}

/// "" if the first argument is a command or an option.
std::string unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-' || std::find(commands.begin(), commands.end(), argv[1]) != commands.end())
    return "";
  const std::string hint = perinox::deck::nearest(argv[1], commands);
  return fmt::format("{} is not a command{}; perinox --help lists the commands", argv[1],
                     hint.empty() ? "" : ", did you mean " + hint + "?");
}

/// Parses the command line and runs the command. `ranks` is null if MPI is not up, as for the command study, whose runs
/// are MPI programs of their own.
int command_line(int argc, char** argv, const perinox::Communicator* ranks, bool is_root) {
  using namespace perinox;
  app::Options options;
  std::string key;
  bool page = false, json_schema = false, study_keys = false;
  study::Request request;
  CLI::App cli{"Implicit quasi-static nonlinear peridynamics on Trilinos", "perinox"};
  cli.set_version_flag("--version", "perinox " PERINOX_VERSION);
  cli.require_subcommand(1);
  auto* run = cli.add_subcommand("run", "solve a deck's load path; under mpirun on N ranks");
  auto* check =
      cli.add_subcommand("check", "validate a deck; print the scene, the resolved deck and what it costs; run nothing");
  auto* verify =
      cli.add_subcommand("verify", "tangent against central differences and symmetry at the scene's own states");
  auto* help = cli.add_subcommand("help", "documentation of a deck's key, an output field or a command");
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
  help->add_option("KEY", key, "a key's dotted path or its last name, an output field, or a command");
  help->add_flag("--page", page, "print the whole reference page, docs/deck.md");
  help->add_flag("--json-schema", json_schema, "print the deck's JSON Schema for editors");
  help->add_flag("--study", study_keys, "print the table of a study's keys");
  give_examples(cli);

  if (const std::string mistake = unknown_command(argc, argv); !mistake.empty()) {
    say(is_root, "perinox: ", mistake);
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
  if (!page && !json_schema && std::find(commands.begin(), commands.end(), key) != commands.end()) {
    if (is_root) fmt::print("{}", cli.get_subcommand(key)->help("perinox"));
    return 0;
  }
  return app::help(key, page, json_schema, *ranks);
}

/// Sets up a process that was started without mpirun and talks to itself only. Two thirds of its start is what Open MPI
/// brings up for others: networks, and a daemon for MPI_Comm_spawn. Without the daemon all such runs of a user would
/// share one folder in /tmp, which the first one to end takes away from the rest; so each gets its own.
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
    setenv("OMPI_MCA_pml", "ob1", 1);  // also replaces what is set for runs on many machines
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
    // Under mpirun the first rank refuses for all. If another rank failed before it, the first would be ended unheard.
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
  // Kokkos takes --help and other options for its own, so it is shown the program's name alone.
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
    // The ranks have not agreed on this error. The others may be waiting for this one, so all are ended.
    fmt::print(stderr, "perinox: rank {}: {}\n", ranks.rank(), error.what());
    std::fflush(stderr);
    if (ranks.size() > 1) MPI_Abort(ranks.mpi(), 1);
    return 1;
  }
}
