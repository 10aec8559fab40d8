#pragma once
#include <string>

#include "perinox/core/communicator.hpp"

namespace perinox::output {

/// Prepares `directory` for a run. It creates it and moves files that an earlier perinox run left in it into
/// `directory/previous-<N>` (the first free N, from 1). Other files stay where they are. Returns one sentence to print
/// about what was moved, or "" if nothing was. Collective. Throws InputError if the directory cannot be made or written
/// to.
std::string prepare_directory(const std::string& directory, const Communicator& communicator);

/// Prepares the directory without moving anything, for a run that goes on in the directory of an earlier one.
void require_directory(const std::string& directory, const Communicator& communicator);

/// Moves one file of the directory into the first free `directory/previous-<N>`. Returns a sentence, or "" if the file
/// was not there. Collective. Throws InputError if it cannot be moved.
std::string set_aside(const std::string& directory, const std::string& file, const Communicator& communicator);

}  // namespace perinox::output
