#pragma once
#include <string>

#include "perinox/deck/schema.hpp"

namespace perinox::study {

/// What the command line asks of a study.
struct Request {
  std::string file;
  std::string output;  ///< folder for everything
  bool again = false;  ///< repeat the runs that are finished
  bool plan = false;   ///< check everything and say what would be run
  bool quiet = false;
};

/// Conducts a study: it runs what is not finished, measures every run, and writes study.csv, the plots and study.md
/// into the folder. The decks of all runs are checked against `schema` before the first one is run. Returns the exit
/// status: 0, or 1 if a run stopped short or could not be measured. Throws InputError for a wrong study or deck,
/// RunError if a file cannot be written. It uses no MPI itself.
int conduct(const Request& request, const deck::Schema& schema);

}  // namespace perinox::study
