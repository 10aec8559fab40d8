#pragma once
#include <string>

#include "perinox/core/communicator.hpp"

namespace perinox::output {

/// Makes `directory` ready for a run: creates it, and moves files that an earlier perinox run left in it into
/// `directory/previous-<N>` (the first free N, from 1); other files stay where they are. Returns one sentence to print
/// about what was moved, "" if nothing was. Collective. Throws InputError if the directory cannot be made or written
/// to.
std::string prepare_directory(const std::string& directory, const Communicator& communicator);

/// The same without moving anything, for a run that goes on in the directory of an earlier one.
void require_directory(const std::string& directory, const Communicator& communicator);

/// Moves one file of the directory into the first free `directory/previous-<N>`. Returns a sentence, "" if it was not
/// there. Collective. Throws InputError if it cannot be moved.
std::string set_aside(const std::string& directory, const std::string& file, const Communicator& communicator);

}  // namespace perinox::output
