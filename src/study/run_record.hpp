#pragma once
#include <optional>
#include <string>

#include "perinox/deck/deck.hpp"
#include "perinox/study/child_process.hpp"

namespace perinox::study {

/// What a study keeps of a finished run beside the run's own files: record.yaml in the run's folder.
struct RunRecord {
  std::string fingerprint;
  Outcome outcome;
  std::string reason;  ///< why it stopped short; empty if it did not
  long long bonds = 0;
};

/// Writes the record whole or not at all. Throws RunError.
void write_record(const std::string& folder, const RunRecord& record);
/// Reads the record. It is absent if there is none, or none that can be read.
std::optional<RunRecord> read_record(const std::string& folder);

/// Hash of everything on which a run's results depend: the resolved deck, the content of the files it names, the number
/// of ranks and of repetitions, and the program itself.
std::string fingerprint(const deck::Deck& deck, int ranks, int repetitions);

/// True for the reason of a run that stopped after a step because somebody sent it a signal.
bool was_told_to_stop(const std::string& reason);

/// The sentence by which a run says why it failed, taken from what it wrote to standard error.
std::string reason_in(const std::string& error_file);
/// Number of directed bonds, taken from the report of the scene at the head of a run's standard output; 0 if it is not
/// there.
long long bonds_in(const std::string& output_file);

}  // namespace perinox::study
