#pragma once
#include <chrono>
#include <ostream>
#include <string>

#include "perinox/core/record.hpp"

namespace perinox::output {

/// Prints the Newton table as text, on one rank: a header a step, a line an iteration, and a line when the step is
/// committed or rejected. With `redraw` a progress line (step, t, iteration, time left) stays at the bottom and is
/// redrawn in place; without it the text holds no control characters.
class Terminal {
 public:
  /// seconds_between_moments: wall-clock seconds between two lines of a motion.
  Terminal(std::ostream& out, bool redraw, double seconds_between_moments = 2)
      : out_(out), redraw_(redraw), seconds_between_moments_(seconds_between_moments) {}

  void newton_iteration(const NewtonIteration& row, int attempt);
  void step_rejected(double t_from, double t_to, const std::string& reason);
  void bonds_broken(const BreakingPass& pass);
  void phase_begins(const MotionPhase& phase);
  void phase_ended(const MotionPhase& phase);
  /// Prints a line if the last one of the motion, its beginning or the last row is long enough ago.
  void moves(const MotionMoment& moment);
  void step_committed(const StepRecord& record);
  /// Prints a line of its own.
  void say(const std::string& line);

 private:
  void print(const std::string& lines);

  std::ostream& out_;
  bool redraw_;
  using Clock = std::chrono::steady_clock;
  double seconds_between_moments_;
  Clock::time_point last_ = Clock::now();
  std::string progress_;   ///< text in the bottom line now
  std::string time_left_;  ///< known from the last committed step
  std::string end_;
};

/// True if standard output ends on a person's screen. A rank under mpirun always writes to a pseudo-terminal, even when
/// mpirun's own output goes to a file; mpirun's output then decides.
bool screen_is_watched();

/// A duration in words: `75 s` -> `1 min 15 s`. It gets coarser as it grows.
std::string duration(double seconds);

}  // namespace perinox::output
