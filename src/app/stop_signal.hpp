#pragma once
#include <string>

namespace perinox::app {

/// From here on SIGTERM, SIGINT and SIGUSR1 do not end the program: they are noted, and where `speaks` is true what
/// happens next is said at once on standard error. A second one of the same kind ends it. (Open MPI hands SIGUSR1 on to
/// the ranks; on the other two it ends them itself.)
void note_stop_signals(bool speaks);

/// "SIGTERM", ... as noted on this rank; "" if none was.
std::string noted_signal();

}  // namespace perinox::app
