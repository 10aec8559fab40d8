/// Tests `perinox help` of a command and of an output field, and the examples of each command's own page.
#include <gmock/gmock.h>

#include <map>

#include "decks.hpp"
#include "program.hpp"

namespace perinox::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The lines of a page that show a call of the program, without what stands before it.
std::vector<std::string> examples_in(const std::string& page) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(page))
    if (line.rfind("  perinox ", 0) == 0 || line.rfind("  mpirun ", 0) == 0) found.push_back(line.substr(2));
  return found;
}

TEST(Help, OfACommandIsItsPage) {
  const Folder folder;
  for (const std::string command : {"run", "check", "verify", "study", "help"}) {
    SCOPED_TRACE(command);
    const Outcome asked = folder.perinox({"help", command}), page = folder.perinox({command, "--help"});
    EXPECT_EQ(asked.status, 0);
    EXPECT_EQ(page.status, 0);
    EXPECT_EQ(asked.error, "");
    EXPECT_EQ(asked.out, page.out);
    EXPECT_THAT(asked.out, HasSubstr("Usage: perinox " + command));
    const std::vector<std::string> examples = examples_in(asked.out);
    EXPECT_GE(examples.size(), 2U);
    for (const std::string& example : examples)
      EXPECT_THAT(example, ::testing::AnyOf(HasSubstr("perinox " + command), HasSubstr("perinox help"))) << example;
  }
  EXPECT_THAT(folder.perinox({"--help"}).out, HasSubstr("perinox COMMAND --help"));
}

/// Every example of a page must name files that exist and be accepted by the command line. `check` stands for the
/// commands that would run.
TEST(Help, TheExamplesAreRight) {
  const std::filesystem::path source = PERINOX_SOURCE_DIR;
  const Folder folder;
  std::filesystem::create_directory_symlink(source / "inputs", folder.path() / "inputs");
  std::filesystem::create_directory_symlink(source / "studies", folder.path() / "studies");
  int tried = 0;
  for (const std::string command : {"run", "check", "verify", "study", "help"})
    for (const std::string& example : examples_in(folder.perinox({"help", command}).out)) {
      SCOPED_TRACE(example);
      std::vector<std::string> words;
      std::istringstream stream(example.substr(example.find("perinox ") + 8));
      for (std::string word; stream >> word && word != "&&";) words.push_back(word);
      if (words[0] == "study" && words.back() != "--plan") continue;
      // The options that only a run has are left out.
      std::vector<std::string> as_check;
      for (std::size_t k = 0; k < words.size(); ++k) {
        if (words[k] == "--output" || words[k] == "--restart")
          ++k;
        else
          as_check.push_back(words[k]);
      }
      if (words[0] == "run" || words[0] == "verify") as_check[0] = "check";
      const Outcome outcome = folder.perinox(as_check);
      EXPECT_EQ(outcome.status, 0) << outcome.error;
      ++tried;
    }
  EXPECT_GT(tried, 10);
}

TEST(Help, OfAnOutputFieldSaysUnitAndScenes) {
  const Folder folder;
  for (const auto& [field, unit] : std::map<std::string, std::string>{{"displacement", "length"},
                                                                      {"force", "force"},
                                                                      {"dilatation", "dimensionless"},
                                                                      {"damage", "dimensionless"},
                                                                      {"stored_energy", "energy/volume"},
                                                                      {"weighted_volume", "length^2*volume"},
                                                                      {"stress", "stress"},
                                                                      {"strain", "dimensionless"},
                                                                      {"von_mises_stress", "stress"},
                                                                      {"plastic_work", "energy/volume"},
                                                                      {"velocity", "velocity"},
                                                                      {"fragment", "dimensionless"},
                                                                      {"plastic_multiplier", "length^2*volume/stress"},
                                                                      {"equivalent_plastic_strain", "dimensionless"},
                                                                      {"plastic_strain_zz", "dimensionless"}}) {
    const Outcome outcome = folder.perinox({"help", field});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr(field + ", an output field\n  "));
    EXPECT_THAT(outcome.out, HasSubstr("\n  unit: " + unit + "\n  values a particle: "));
    EXPECT_THAT(outcome.out, HasSubstr("\n  exists: "));
  }
  EXPECT_THAT(folder.perinox({"help", "plastic_strain_zz"}).out,
              HasSubstr("exists: in 2-D, where a material is elastic-"));
  EXPECT_THAT(folder.perinox({"help", "output.fields"}).out, HasSubstr("von_mises_stress"));
}

}  // namespace
}  // namespace perinox::cli
