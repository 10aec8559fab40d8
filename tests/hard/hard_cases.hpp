#pragma once
#include <string>
#include <vector>

namespace perinox::test {

inline const std::string hard_folder = PERINOX_SOURCE_DIR "/inputs/hard/";

enum class Outcome { converged, stopped, refused };
std::string name_of(Outcome outcome);

struct CaseResult {
  std::string deck;
  Outcome outcome = Outcome::converged;
  int steps = 0, rejected = 0, newton = 0, linear = 0;
  double gap = 0;        ///< external work less what is stored, dissipated and lost in jumps, over the largest of these
  std::string sentence;  ///< why it stopped or was refused
  // The following are not in the file.
  double stored = 0;
  std::vector<double> history;  ///< history of all steps, entry by entry
};

/// Runs inputs/hard/<deck>.yaml in this process.
CaseResult run_case(const std::string& deck);
std::vector<CaseResult> read_outcomes(const std::string& path);
void write_outcomes(const std::string& path, const std::vector<CaseResult>& results);
/// The text of docs/hard_cases.md.
std::string page_of(const std::vector<CaseResult>& results);

}  // namespace perinox::test
