#pragma once
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"
#include "perinox/deck/deck.hpp"
#include "perinox/deck/schema.hpp"
#include "perinox/study/conduct.hpp"

namespace perinox::app {

/// What the command line asks for besides the deck.
struct Options {
  std::string deck;
  std::string output;                  ///< --output; empty: results/<deck's name>
  std::vector<std::string> overrides;  ///< --set key.path=value
  std::string restart;                 ///< --restart: a checkpoint, or the directory of one; empty: from t = 0
  bool quiet = false;
};

/// Reads the deck on every rank. All ranks leave together if any of them cannot. Collective.
deck::Deck read_deck(const Options& options, const Communicator& communicator);

// The commands. Each one is collective, prints on rank 0, and returns the exit status or throws InputError (status 2)
// or RunError (status 1).
int run(const Options& options, const Communicator& communicator);
int check(const Options& options, const Communicator& communicator);
int verify(const Options& options, const Communicator& communicator);
/// Prints help on a key of the deck; an empty key stands for the list of keys. `--page` and `--json-schema` print the
/// generated documents.
int help(const std::string& key, bool page, bool json_schema, const Communicator& communicator);
/// Prints the table of a study's keys, for docs/studies.md.
int study_keys(const Communicator& communicator);

/// Conducts a study. It uses no MPI and refuses to be one of several ranks.
int study(study::Request request);

}  // namespace perinox::app
