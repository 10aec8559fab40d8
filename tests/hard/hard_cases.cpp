#include "hard_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "support/runs.hpp"

namespace perinox::test {

namespace {
/// The comment at the head of a deck, in one line.
std::string comment_of(const std::string& deck) {
  std::ifstream file(hard_folder + deck + ".yaml");
  std::string text;
  for (std::string line; std::getline(file, line) && line.rfind("# ", 0) == 0;)
    text += (text.empty() ? "" : " ") + line.substr(2);
  return text;
}
}  // namespace

std::string name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::converged:
      return "converged";
    case Outcome::stopped:
      return "stopped";
    case Outcome::refused:
      break;
  }
  return "refused";
}

CaseResult run_case(const std::string& deck) {
  CaseResult result;
  result.deck = deck;
  try {
    const RunResult run = run_deck(deck::read(hard_folder + deck + ".yaml", materials::full_schema()));
    if (!run.stopped.empty()) result.outcome = Outcome::stopped;
    result.sentence = run.stopped;
    result.steps = static_cast<int>(run.records.steps.size());
    result.rejected = static_cast<int>(run.records.reasons.size());
    for (const StepRecord& step : run.records.steps) {
      result.newton += step.newton_iterations;
      result.linear += step.linear_iterations;
      result.history.insert(result.history.end(), step.history.begin(), step.history.end());
    }
    const stepping::Energies& e = run.energies;
    const double size = std::max({std::abs(e.external_work), std::abs(e.stored), std::abs(e.dissipated)});
    result.gap = size > 0 ? (e.external_work - e.stored - e.dissipated - e.relaxed) / size : 0;
    result.stored = e.stored;
  } catch (const InputError& refusal) {
    result.outcome = Outcome::refused;
    result.sentence = refusal.what();
  }
  // A path of this machine must not be in the file.
  for (std::size_t at; (at = result.sentence.find(PERINOX_SOURCE_DIR "/")) != std::string::npos;)
    result.sentence.erase(at, std::string(PERINOX_SOURCE_DIR "/").size());
  return result;
}

void write_outcomes(const std::string& path, const std::vector<CaseResult>& results) {
  std::ofstream file(path);
  file << "deck;outcome;steps;rejected;newton;linear;gap;sentence\n";
  for (const CaseResult& one : results)
    file << fmt::format("{};{};{};{};{};{};{:.1e};{}\n", one.deck, name_of(one.outcome), one.steps, one.rejected,
                        one.newton, one.linear, one.gap, one.sentence);
}

std::vector<CaseResult> read_outcomes(const std::string& path) {
  std::vector<CaseResult> results;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);  // the header
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<std::string> cell(7);
    for (std::string& one : cell) std::getline(cells, one, ';');
    CaseResult result;
    result.deck = cell[0];
    for (const Outcome outcome : {Outcome::converged, Outcome::stopped, Outcome::refused})
      if (name_of(outcome) == cell[1]) result.outcome = outcome;
    result.steps = std::stoi(cell[2]);
    result.rejected = std::stoi(cell[3]);
    result.newton = std::stoi(cell[4]);
    result.linear = std::stoi(cell[5]);
    result.gap = std::stod(cell[6]);
    std::getline(cells, result.sentence);
    results.push_back(result);
  }
  return results;
}

std::string page_of(const std::vector<CaseResult>& results) {
  std::string text = R"(# Hard cases

What other solvers abort at, as decks in `inputs/hard/`. Each converges with its energies in balance, or stops (status 1) or
is refused (status 2) with the true reason. `build/test_hard` (CTest label `hard`) runs them all and fails where one ends
otherwise or takes more iterations; this page is written by `PERINOX_WRITE_GOLDEN=1 build/test_hard`.

    perinox run inputs/hard/post_buckling.yaml --output results/post_buckling

What helps: a line search that lets through full steps of bodies that bend and turn, linear solves that become tighter
where an attempt has failed, a direct solver for slender bodies, and, where stability is lost at the smallest load step,
going down in energy to the next stable equilibrium ([theory.md](theory.md)). Answers are tested too: three systems of
units agree to 1e-10, the energy of a turned block does not change, the slender bar bends as the elastica.

"Energy" is the share of the external work that is neither stored nor dissipated: what Newton's tolerance, 1e-9, leaves
([theory.md](theory.md#4-energy-and-dissipation)).

| deck | what is hard | ends | steps | rejected | Newton | linear | energy |
|---|---|---|---|---|---|---|---|
)";
  std::string sentences;
  for (const CaseResult& one : results) {
    const bool ran = one.outcome != Outcome::refused;
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", one.deck, comment_of(one.deck), name_of(one.outcome),
                    ran ? std::to_string(one.steps) : "", ran ? std::to_string(one.rejected) : "",
                    ran ? std::to_string(one.newton) : "", ran ? std::to_string(one.linear) : "",
                    one.outcome == Outcome::converged ? fmt::format("{:.1e}", one.gap) : "");
    if (!one.sentence.empty()) sentences += fmt::format("- `{}`: {}\n", one.deck, one.sentence);
  }
  return text + "\nWhat the others say:\n\n" + sentences;
}

}  // namespace perinox::test
