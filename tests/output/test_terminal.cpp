#include <gmock/gmock.h>

#include <sstream>

#include "output/terminal.hpp"
#include "support/shuffled_body.hpp"

namespace perinox::output {
namespace {
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

void tell_a_step(Terminal& terminal) {
  terminal.newton_iteration({1, 0.5, 0, 1234.5, 1, 0, 0, 0, 0, 1}, 1);
  terminal.newton_iteration({1, 0.5, 1, 99.5, 0.0806, 0.031, 1, 12, 1e-4, 1}, 1);
  terminal.step_rejected(0, 0.5, "the line search found no descent");
  terminal.newton_iteration({1, 0.25, 0, 600, 0.5, 0, 0, 0, 0, 1}, 2);
  StepRecord record = test::step_record(1, 0.25);
  record.seconds = 2.04;
  record.remaining_seconds = 75;
  terminal.step_committed(record);
}

TEST(Terminal, PrintsAnAlignedTable) {
  std::ostringstream out;
  Terminal terminal(out, false);
  tell_a_step(terminal);
  EXPECT_EQ(out.str(), R"(
step 1   t = 0.5
  iteration     residual    relative       update    relative   linear    forcing
          0    1.234e+03    1.00e+00            -           -        -          -
          1    9.950e+01    8.06e-02    3.100e-02    1.00e+00       12    1.0e-04
  rejected, t = 0 to 0.5: the line search found no descent

step 1 (attempt 2)   t = 0.25
  iteration     residual    relative       update    relative   linear    forcing
          0    6.000e+02    5.00e-01            -           -        -          -
  committed step 1 at t = 0.25: 3 Newton iterations, 41 linear iterations, 2.0 s, about 1 min 15 s left
)");
}

TEST(Terminal, RedrawsOneProgressLineAtTheBottom) {
  std::ostringstream out;
  Terminal terminal(out, true);
  tell_a_step(terminal);
  EXPECT_THAT(out.str(), EndsWith("left\nstep 1  t 0.25 of 1  about 1 min 15 s left"));
  terminal.newton_iteration({2, 0.5, 0, 1, 1, 0, 0, 0, 0, 1}, 1);
  EXPECT_THAT(out.str(), HasSubstr("\r\033[K\nstep 2   t = 0.5\n"));
  EXPECT_THAT(out.str(), EndsWith("\nstep 2  t 0.5 of 1  iteration 0  about 1 min 15 s left"));
  StepRecord last = test::step_record(2, 1);
  last.last = true;
  terminal.step_committed(last);
  EXPECT_THAT(out.str(), EndsWith(" s\n"));  // nothing is left behind in the bottom line
}

// A phase of hours is not silent, and one of many short looks does not flood the log.
TEST(Terminal, SaysWhereAMotionIsFromTimeToTime) {
  MotionPhase phase;
  phase.t_begin = 0.5;
  phase.reason = "the crack runs";
  const MotionMoment moment{0.5, 2e-6, 1270, 1.25, 3.5, 0.75, 12};
  std::ostringstream out;
  Terminal often(out, false, 0);
  often.phase_begins(phase);
  often.moves(moment);
  EXPECT_EQ(out.str(),
            "  goes on in time from t = 0.5: the crack runs\n"
            "  in motion at t = 0.5, time 2e-06, 1270 time steps: kinetic 1.25, stored 3.5, damped 0.75, 12 broken "
            "bonds\n");
  std::ostringstream quiet;
  Terminal usual(quiet, false);
  usual.phase_begins(phase);
  for (int k = 0; k < 1000; ++k) usual.moves(moment);
  EXPECT_EQ(quiet.str(), "  goes on in time from t = 0.5: the crack runs\n");  // two seconds are not over
}

TEST(Terminal, SaysDurationsAsPeopleDo) {
  EXPECT_EQ(duration(0.04), "0.0 s");
  EXPECT_EQ(duration(12.4), "12 s");
  EXPECT_EQ(duration(59.7), "1 min 0 s");
  EXPECT_EQ(duration(7265), "2 h 1 min");
}

}  // namespace
}  // namespace perinox::output
