#include "stop_signal.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>

namespace perinox::app {

namespace {

volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t speaking = 0;

// Does only what a signal handler may do: it asks for no memory and leaves errno as it was.
void say(std::string_view text) {
  const int before = errno;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  errno = before;
}

extern "C" void note(int signal) {
  noted = signal;
  if (speaking != 0) {
    say(signal == SIGTERM ? "\nperinox: SIGTERM" : signal == SIGINT ? "\nperinox: SIGINT" : "\nperinox: SIGUSR1");
    say(": stops after the step at hand; a second one ends the run at once\n");
  }
  std::signal(signal, SIG_DFL);
}

}  // namespace

void note_stop_signals(bool speaks) {
  speaking = speaks ? 1 : 0;
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) std::signal(signal, note);
}

std::string noted_signal() {
  switch (noted) {
    case SIGTERM:
      return "SIGTERM";
    case SIGINT:
      return "SIGINT";
    case SIGUSR1:
      return "SIGUSR1";
    default:
      return "";
  }
}

}  // namespace perinox::app
