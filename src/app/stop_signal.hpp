#pragma once
#include <string>

namespace perinox::app {

/// From here on SIGTERM, SIGINT and SIGUSR1 do not end the program. They are noted, and where `speaks` is true the
/// program says at once on standard error what happens next. A second signal of the same kind ends it. (Open MPI hands
/// SIGUSR1 on to the ranks; on the other two it ends them itself.)
void note_stop_signals(bool speaks);

/// The signal that was noted on this rank, such as "SIGTERM"; "" if there was none.
std::string noted_signal();

}  // namespace perinox::app
