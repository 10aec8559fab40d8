#pragma once
#include <optional>
#include <string>

#include "perinox/deck/deck.hpp"
#include "perinox/study/child_process.hpp"

namespace perinox::study {

/// What a study keeps of a finished run beside the run's own files, as record.yaml in the run's folder.
struct RunRecord {
  std::string fingerprint;
  Outcome outcome;
  std::string reason;  ///< why it stopped short; empty if it did not
  long long bonds = 0;
};

/// Written whole or not at all. Throws RunError.
void write_record(const std::string& folder, const RunRecord& record);
/// Nothing if there is none, or none that can be read.
std::optional<RunRecord> read_record(const std::string& folder);

/// Hash of everything a run's results depend on: the resolved deck, the content of the files it names, the number of
/// ranks and of repetitions, and the program itself.
std::string fingerprint(const deck::Deck& deck, int ranks, int repetitions);

/// True of the reason of a run that stopped after a step because somebody sent it a signal.
bool was_told_to_stop(const std::string& reason);

/// The sentence by which a run says why it failed, from what it wrote to standard error.
std::string reason_in(const std::string& error_file);
/// Directed bonds, from the report of the scene at the head of a run's standard output; 0 if it is not there.
long long bonds_in(const std::string& output_file);

}  // namespace perinox::study
