/// Tests the commands as docs/commands.md describes them: exit statuses, help, generated documents, what a run leaves
/// behind.
#include <gmock/gmock.h>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

const std::filesystem::path source = PERINOX_SOURCE_DIR;

/// The text of history.csv up to its column of seconds. The columns behind it are times too.
std::vector<std::string> history_without_seconds(const std::filesystem::path& results) {
  std::vector<std::string> lines = lines_of(read(results / "history.csv"));
  EXPECT_TRUE(!lines.empty() && lines.front().find(",seconds") != std::string::npos) << results << " has no history";
  // No name of a column in these decks holds a comma.
  const std::string before = lines.front().substr(0, lines.front().find(",seconds"));
  const auto columns = std::count(before.begin(), before.end(), ',') + 1;
  for (std::string& line : lines) {
    std::size_t end = 0;
    for (auto k = columns; k > 0; --k) end = line.find(',', end) + 1;
    line.erase(end - 1);
  }
  return lines;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

// --- the command line ---------------------------------------------------------------------------------------------

struct WrongLine {
  std::vector<std::string> arguments;
  std::string sentence;
};

TEST(CommandLine, IsRefusedWithStatusTwo) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const std::string lists = "; perinox --help lists the commands\n";
  const WrongLine lines[] = {
      {{}, "perinox: A subcommand is required" + lists},
      {{"run"}, "perinox: DECK is required" + lists},
      {{"rum", "deck.yaml"}, "perinox: rum is not a command, did you mean run?" + lists},
      {{"frobnicate"}, "perinox: frobnicate is not a command" + lists},
      {{"run", "deck.yaml", "--ouput", "x"}, "perinox: The following arguments were not expected: x --ouput" + lists},
      {{"check", "deck.yaml", "--output", "x"},
       "perinox: The following arguments were not expected: x --output" + lists},
      {{"check", "deck.yaml", "other.yaml"}, "perinox: The following argument was not expected: other.yaml" + lists},
      {{"check", "no_such.yaml"}, "no_such.yaml: there is no deck of this name; check the path\n"},
      {{"check", "."}, ".: this is a folder; name the deck file in it\n"},
      {{"check", "deck.yaml", "--set", "steps.count"},
       "--set steps.count: an override is written key.path=value, for example solver.newton.tolerance=1e-9\n"},
      {{"check", "deck.yaml", "--set", "steps.cont=3"},
       "--set steps.cont=3: cont is not a key of steps; did you mean count?\n"},
      {{"check", "deck.yaml", "--set", "body.4.spacing=3"},
       "--set body.4.spacing=3: body has 1 entry, counted from 0; there is no entry 4\n"},
  };
  for (const WrongLine& line : lines) {
    SCOPED_TRACE(::testing::PrintToString(line.arguments));
    const Outcome outcome = folder.perinox(line.arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error, line.sentence);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(folder.names(), ElementsAre("deck.yaml"));
  }
}

TEST(CommandLine, HelpAndVersionAreTheProgramsOwn) {
  const Folder folder;
  const Outcome help = folder.perinox({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.out, StartsWith("Implicit quasi-static nonlinear peridynamics"));
  EXPECT_THAT(help.out, ::testing::Not(HasSubstr("kokkos")));
  const Outcome version = folder.perinox({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_THAT(version.out, ::testing::MatchesRegex("perinox [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(CommandLine, AnOutputThatIsAFileIsRefused) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  folder.write("taken", "a file\n");
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "taken", "--quiet"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.error, StartsWith("the output directory taken cannot be used: "));
  EXPECT_THAT(outcome.error, ::testing::EndsWith("; choose another with --output\n"));
  EXPECT_EQ(read(folder.path() / "taken"), "a file\n");
}

// --- run ----------------------------------------------------------------------------------------------------------

TEST(Run, LeavesItsFilesAndStatusZero) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "0.01*t", "0.001*t"));  // nothing flows
  const Outcome outcome = folder.perinox({"run", "deck.yaml"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(outcome.out, HasSubstr("results in results/deck\n"));
  for (const char* name : {"results.h5", "results.xdmf", "history.csv", "convergence.csv", "deck.resolved.yaml"})
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "results/deck" / name)) << name;
  EXPECT_EQ(history_without_seconds(folder.path() / "results/deck").size(), 4);  // header, start and two steps
}

TEST(Run, WarnsWhereTheEnergiesDoNotAgree) {
  const Folder folder;
  // This is a step in which bonds turn far.
  folder.write("deck.yaml", changed(base_deck, "{z: \"0.01*t\"}", "{y: \"0.6*t\", z: \"0.2*t\"}"));
  const Outcome loose = folder.perinox({"run", "deck.yaml", "--quiet", "--set", "steps.count=1", "--set",
                                        "solver.newton.tolerance=0.5", "--set", "solver.newton.update_tolerance=1"});
  EXPECT_EQ(loose.status, 0);
  EXPECT_EQ(loose.out, "");
  EXPECT_THAT(loose.error, HasSubstr("warning: the external work is "));
  EXPECT_THAT(loose.error, HasSubstr("take a smaller solver.newton.tolerance"));
  EXPECT_THAT(folder.perinox({"run", "deck.yaml", "--quiet", "--set", "steps.count=1"}).error,
              ::testing::Not(HasSubstr("the external work")));
}

TEST(Run, OthersAtTheSameTimeDoNotMatter) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  std::vector<Outcome> outcomes(6);
  std::vector<std::thread> runs;
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    runs.emplace_back([&, k] {
      outcomes[k] = folder.perinox({"run", "deck.yaml", "--output", "results" + std::to_string(k)});
    });
  for (std::thread& run : runs) run.join();
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "");
  }
}

TEST(Run, QuietSaysNothing) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "0.01*t", "0.001*t"));
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--quiet", "--output", "here"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(folder.names(), ElementsAre("deck.yaml", "here"));
}

// Three small steps are followed by one that no Newton iteration can take.
TEST(Run, StopsShortWithTheReasonAndTheLastGoodStepOnDisk) {
  const Folder folder;
  folder.write("deck.yaml", changed(changed(changed(base_deck, "0.01*t", "t < 0.8 ? 1e-4*t : 3"), "count: 2",
                                            "count: 4, adaptive: false"),
                                    "tolerance: 1e-8", "max_iterations: 4"));
  const Outcome outcome = folder.perinox({"run", "deck.yaml", "--output", "r", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.error,
              StartsWith("perinox: stopped at t = 0.75 of 1, after 3 converged steps: the step to t = 1 does "
                         "not converge and steps.adaptive is false; "));
  EXPECT_EQ(lines_of(outcome.error).size(), 2) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("\nresume with: perinox run deck.yaml --restart r/checkpoint.h5\n"));
  EXPECT_EQ(history_without_seconds(folder.path() / "r").size(), 5);
  EXPECT_EQ(count(read(folder.path() / "r/results.xdmf"), "<Time "), 4);
}

TEST(Run, KeepsEarlierResults) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "r"}).status, 0);
  const std::string first = read(folder.path() / "r/history.csv");
  const Outcome again = folder.perinox({"run", "deck.yaml", "--output", "r"});
  EXPECT_EQ(again.status, 0);
  EXPECT_THAT(again.out, HasSubstr("r held earlier results: 6 files are moved to r/previous-1\n"));
  EXPECT_EQ(read(folder.path() / "r/previous-1/history.csv"), first);
}

TEST(Run, TheResolvedDeckReproducesTheRun) {
  for (const std::string* deck : {&base_deck, &flat_deck, &cloud_deck}) {
    const Folder folder;
    folder.write("deck.yaml", *deck);
    folder.write("cloud.csv", cloud);
    folder.write("field.csv", field);
    ASSERT_EQ(folder.perinox({"run", "deck.yaml", "--output", "first", "--quiet"}).status, 0);
    ASSERT_EQ(folder.perinox({"run", "first/deck.resolved.yaml", "--output", "second", "--quiet"}).status, 0);
    EXPECT_EQ(history_without_seconds(folder.path() / "first"), history_without_seconds(folder.path() / "second"));
    EXPECT_EQ(read(folder.path() / "first/deck.resolved.yaml"), read(folder.path() / "second/deck.resolved.yaml"));
  }
}

TEST(Run, AnOverrideIsInTheResolvedDeck) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  ASSERT_EQ(folder
                .perinox({"run", "deck.yaml", "--output", "r", "--quiet", "--set", "steps.count=3", "--set",
                          "horizon={length: 1.5}"})
                .status,
            0);
  EXPECT_THAT(read(folder.path() / "r/deck.resolved.yaml"), HasSubstr("horizon: {length: 1.5}\n"));
  EXPECT_EQ(history_without_seconds(folder.path() / "r").size(), 5);
}

TEST(Run, AndCheckAndVerifyTellOfAnUnknownThatIsPrescribedTwice) {
  for (const char* command : {"run", "check", "verify"}) {
    SCOPED_TRACE(command);
    const Folder folder;
    folder.write("deck.yaml", changed(base_deck, "steps:", "  - {set: head, displacement: {z: \"0.0005*t\"}}\nsteps:"));
    const Outcome outcome = folder.perinox({command, "deck.yaml", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(
        outcome.error,
        "note: deck.yaml:23:5: prescribes 9 unknowns that an earlier entry prescribes too; this later one counts\n");
  }
}

// --- check and verify ---------------------------------------------------------------------------------------------

TEST(Check, PrintsADeckThatCanBeRun) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const Outcome checked = folder.perinox({"check", "deck.yaml"});
  EXPECT_EQ(checked.status, 0);
  const std::size_t begin = checked.out.find("# the resolved deck\n");
  ASSERT_NE(begin, std::string::npos);
  folder.write("resolved.yaml", checked.out.substr(begin));
  EXPECT_EQ(folder.perinox({"check", "resolved.yaml", "--quiet"}).status, 0);
}

TEST(Verify, HoldsForTheConsistentTangentAndNotForThePrintedOne) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const Outcome consistent = folder.perinox({"verify", "deck.yaml"});
  EXPECT_EQ(consistent.status, 0) << consistent.out;
  EXPECT_THAT(consistent.out, HasSubstr("\nthe tangent holds: "));
  const Outcome printed = folder.perinox(
      {"verify", "deck.yaml", "--set", "solver.form=printed", "--set", "solver.newton.max_iterations=500", "--quiet"});
  EXPECT_EQ(printed.status, 1) << printed.out;
}

TEST(Check, SaysWhereTheStrainIsFitted) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const auto said = [&](const std::string& quadrature) {
    return folder.perinox({"check", "deck.yaml", "--set", "quadrature=" + quadrature}).out;
  };
  EXPECT_THAT(
      said("position-aware"),
      HasSubstr("\n  strain fitted at 36 of 36 particles: bonds with such an end carry 6 sums instead of one\n"));
  EXPECT_THAT(said("whole"), ::testing::Not(HasSubstr("fitted")));
}

TEST(Check, SaysHowManyStepsAndWarnsOfYears) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const auto said = [&](const std::string& count) {
    return folder.perinox({"check", "deck.yaml", "--set", "steps.count=" + count}).out;
  };
  EXPECT_THAT(said("20"), HasSubstr("\nload steps\n  20 of them, each 0.05 in t, every one written to results.h5; at "
                                    "least about "));
  EXPECT_THAT(said("20"), ::testing::Not(HasSubstr("warning")));
  folder.write("deck.yaml", changed(base_deck, "spacing: 1.0", "spacing: 0.1"));
  EXPECT_THAT(said("1000000000"), HasSubstr(" years of a core; is steps.count what you mean?\n"));
}

TEST(Check, SaysWhichTangentAndWhy) {
  const Folder folder;
  folder.write("deck.yaml", changed(base_deck, "  tangent: matrix-free\n", ""));
  const auto said = [&](const std::vector<std::string>& overrides) {
    std::vector<std::string> arguments{"check", "deck.yaml"};
    for (const std::string& one : overrides) arguments.insert(arguments.end(), {"--set", one});
    return folder.perinox(arguments).out;
  };
  EXPECT_THAT(said({}),
              HasSubstr("\n  tangent matrix-free: nothing that the deck asks for needs a matrix; a matrix would "
                        "take about "));
  EXPECT_THAT(said({"solver.tangent=matrix-free"}), HasSubstr("\n  tangent matrix-free: the deck asks for it; "));
  EXPECT_THAT(said({"solver.tangent=assembled"}), HasSubstr("\n  tangent assembled: the deck asks for it; "));
  EXPECT_THAT(said({"solver.linear.preconditioner=ilu"}),
              HasSubstr("\n  tangent assembled: the preconditioner needs it; "));
  EXPECT_THAT(said({"solver.linear.method=direct"}), HasSubstr("\n  tangent assembled: the direct method needs it; "));
  EXPECT_THAT(said({"solver.linear.method=direct"}), HasSubstr(", its factors on rank 0 up to 93.3 kB"));
}

TEST(Run, EndsWithATableOfItsTimes) {
  const Folder folder;
  folder.write("deck.yaml", base_deck);
  const Outcome outcome = folder.perinox_on_ranks(2, {"run", "deck.yaml", "--output", "r"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("\ntime of the run      seconds    share      count\n"));
  for (const char* section : {"product", "halo", "force", "linearise", "output", "rest", "total"})
    EXPECT_THAT(outcome.out, HasSubstr(std::string("\n  ") + section + " ")) << section;
  const std::vector<std::string> history = lines_of(read(folder.path() / "r/history.csv"));
  EXPECT_THAT(history.front(), HasSubstr(",seconds,products,seconds_product,"));
  EXPECT_EQ(std::count(history.front().begin(), history.front().end(), ','),
            std::count(history.back().begin(), history.back().end(), ','));
  // A run that stops short also says where its time went.
  const Outcome stopped = folder.perinox({"run", "deck.yaml", "--output", "s", "--set", "steps.adaptive=false", "--set",
                                          "solver.newton.max_iterations=1", "--set", "solver.newton.tolerance=1e-14"});
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.out, HasSubstr("\ntime of the run "));
}

// --- help ---------------------------------------------------------------------------------------------------------

TEST(Help, TellsOfAKey) {
  const Folder folder;
  struct Asked {
    std::string key, first_line, part;
  };
  for (const Asked& asked :
       {Asked{"horizon", "horizon\n", "keys:\n    ratio "},
        Asked{"solver.newton.tolerance", "solver.newton.tolerance\n", "default: 1e-9\n"},
        Asked{"materials.aluminium.yield_stress", "materials.elastic-plastic.yield_stress\n", "shear "},
        Asked{"max_cuts", "steps.max_cuts\n", "range: at least 0 and at most 60\n"},
        Asked{"", "The deck's keys", "boundary "}}) {
    SCOPED_TRACE(asked.key);
    const Outcome outcome = asked.key.empty() ? folder.perinox({"help"}) : folder.perinox({"help", asked.key});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, StartsWith(asked.first_line));
    EXPECT_THAT(outcome.out, HasSubstr(asked.part));
    EXPECT_EQ(outcome.error, "");
  }
}

TEST(Help, SuggestsTheNearestKey) {
  const Folder folder;
  for (const auto& [asked, sentence] :
       {std::pair{"yeild_stress",
                  "yeild_stress is neither a key of a deck nor an output field; did you mean yield_stress?\n"},
        std::pair{"solver.newton.tolerence",
                  "solver.newton.tolerence is neither a key of a deck nor an output field; did you mean "
                  "solver.newton.tolerance?\n"},
        std::pair{"gravity",
                  "gravity is neither a key of a deck nor an output field; perinox help lists the keys, "
                  "perinox --help the commands\n"}}) {
    const Outcome outcome = folder.perinox({"help", asked});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.error, sentence);
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(Help, TheGeneratedDocumentsAreUpToDate) {
  const Folder folder;
  for (const auto& [option, file] :
       {std::pair{"--page", "docs/deck.md"}, std::pair{"--json-schema", "docs/deck.schema.json"}}) {
    const Outcome outcome = folder.perinox({"help", option});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_TRUE(outcome.out == read(source / file))
        << file << " is not what the program says of its deck; write it again:\n  " << PERINOX_BINARY << " help "
        << option << " > " << (source / file).string();
  }
}

// --- the decks of inputs/ -----------------------------------------------------------------------------------------

std::vector<std::string> inputs() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source / "inputs"))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The command line in the comment at a deck's head: `#   mpirun -np 2 perinox run inputs/...`.
std::vector<std::string> command_of(const std::string& deck) {
  for (const std::string& line : lines_of(deck)) {
    if (line.empty() || line[0] != '#') break;
    if (line.rfind("#   ", 0) != 0 || line.find("perinox ") == std::string::npos) continue;
    std::vector<std::string> words;
    std::istringstream stream(line.substr(4));
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
  }
  return {};
}

class Input : public ::testing::TestWithParam<std::string> {};

TEST_P(Input, IsValidAndItsCommandRuns) {
  const Folder folder;
  std::filesystem::create_directory_symlink(source / "inputs", folder.path() / "inputs");
  const std::string deck = "inputs/" + GetParam() + ".yaml";
  const Outcome checked = folder.perinox({"check", deck});
  ASSERT_EQ(checked.status, 0) << checked.error;
  EXPECT_EQ(checked.error, "");

  std::vector<std::string> words = command_of(read(folder.path() / deck));
  ASSERT_FALSE(words.empty()) << deck << " has no line `#   perinox run " << deck << "` at its head";
  int ranks = 1;
  if (words[0] == "mpirun") {
    ASSERT_GE(words.size(), 4);
    ASSERT_EQ(words[1], "-np");
    ranks = std::stoi(words[2]);
    words.erase(words.begin(), words.begin() + 3);
  }
  ASSERT_EQ(words[0], "perinox");
  words.erase(words.begin());
  ASSERT_THAT(words, IsSupersetOf({std::string("run"), deck}));
  const Outcome ran = ranks == 1 ? folder.perinox(words) : folder.perinox_on_ranks(ranks, words);
  EXPECT_EQ(ran.status, 0) << ran.error;
  EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / "results" / GetParam() / "results.h5"));
}

INSTANTIATE_TEST_SUITE_P(Cli, Input, ::testing::ValuesIn(inputs()), [](const auto& one) { return one.param; });

// The first ```yaml block of the README is a whole deck.
TEST(Readme, TheFirstDeckIsValid) {
  const std::string text = read(source / "README.md");
  const std::string fence = "```yaml\n";
  const std::size_t begin = text.find(fence);
  ASSERT_NE(begin, std::string::npos);
  const Folder folder;
  folder.write("first.yaml", text.substr(begin + fence.size(), text.find("```\n", begin + 1) - begin - fence.size()));
  const Outcome outcome = folder.perinox({"check", "first.yaml"});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("  block: 3000 particles of aluminium\n"));
}

}  // namespace
}  // namespace perinox::cli
