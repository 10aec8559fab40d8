#include "terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace perinox::output {

namespace {
constexpr const char* erase_line = "\r\033[K";

std::string plural(long long count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}
}  // namespace

bool screen_is_watched() {
  const char* kind = std::getenv("TERM");
  if (::isatty(STDOUT_FILENO) == 0 || kind == nullptr || std::string(kind) == "dumb") return false;
  if (std::getenv("OMPI_COMM_WORLD_RANK") == nullptr && std::getenv("PMI_RANK") == nullptr) return true;
  std::error_code error;
  const std::string launcher = std::filesystem::read_symlink(fmt::format("/proc/{}/fd/1", ::getppid()), error).string();
  return !error && launcher.rfind("/dev/", 0) == 0 && launcher != "/dev/null";
}

std::string duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

void Terminal::print(const std::string& lines) {
  if (redraw_ && !progress_.empty()) out_ << erase_line;
  out_ << lines;
  if (redraw_) out_ << progress_;
  out_.flush();
}

void Terminal::say(const std::string& line) { print(line + "\n"); }

void Terminal::newton_iteration(const NewtonIteration& row, int attempt) {
  std::string lines;
  if (row.iteration == 0) {
    lines = fmt::format("\nstep {}{}   t = {:.6g}\n{:>11}{:>13}{:>12}{:>13}{:>12}{:>9}{:>11}\n", row.step,
                        attempt == 1 ? "" : fmt::format(" (attempt {})", attempt), row.t, "iteration", "residual",
                        "relative", "update", "relative", "linear", "forcing");
    lines += fmt::format("{:>11}{:>13.3e}{:>12.2e}{:>13}{:>12}{:>9}{:>11}\n", 0, row.residual, row.relative_residual,
                         "-", "-", "-", "-");
  } else {
    lines = fmt::format("{:>11}{:>13.3e}{:>12.2e}{:>13.3e}{:>12.2e}{:>9}{:>11.1e}\n", row.iteration, row.residual,
                        row.relative_residual, row.update, row.relative_update, row.linear_iterations, row.forcing);
  }
  progress_ = fmt::format("step {}  t {:.6g}{}  iteration {}{}", row.step, row.t, end_, row.iteration, time_left_);
  print(lines);
}

void Terminal::step_rejected(double t_from, double t_to, const std::string& reason) {
  print(fmt::format("  rejected, t = {:.6g} to {:.6g}: {}\n", t_from, t_to, reason));
}

void Terminal::bonds_broken(const BreakingPass& pass) {
  print(fmt::format("  pass {} at t = {:.6g}: {} of {} critical bonds broken, the worst at {:.4g} of its limit\n",
                    pass.pass, pass.t, pass.broken, pass.critical, pass.worst));
}

void Terminal::phase_begins(const MotionPhase& phase) {
  print(fmt::format("  goes on in time from t = {:.6g}: {}\n", phase.t_begin, phase.reason));
  last_ = Clock::now();
}

void Terminal::moves(const MotionMoment& moment) {
  const auto now = Clock::now();
  if (std::chrono::duration<double>(now - last_).count() < seconds_between_moments_) return;
  last_ = now;
  print(
      fmt::format("  in motion at t = {:.6g}, time {:.6g}, {} time steps: kinetic {:.4g}, stored {:.4g}, damped "
                  "{:.4g}, {}\n",
                  moment.t, moment.time, moment.time_steps, moment.kinetic_energy, moment.stored_energy,
                  moment.damped_energy, plural(moment.broken_bonds, "broken bond")));
}

void Terminal::phase_ended(const MotionPhase& phase) {
  print(
      fmt::format("  {} at t = {:.6g} after {:.4g} of time in {} time steps: {} bonds broken, {:.4g} of energy "
                  "released and {:.4g} damped, {:.1e} of it not accounted for\n",
                  phase.at_rest ? "at rest" : "not at rest", phase.t_end, phase.time, phase.time_steps,
                  phase.broken_bonds, phase.released_energy, phase.damped_energy, phase.unaccounted_share));
}

void Terminal::step_committed(const StepRecord& record) {
  last_ = Clock::now();
  const std::string left = record.last ? "" : fmt::format(", about {} left", duration(record.remaining_seconds));
  end_ = fmt::format(" of {:.6g}", record.end);
  time_left_ = record.last ? "" : fmt::format("  about {} left", duration(record.remaining_seconds));
  progress_ = record.last ? "" : fmt::format("step {}  t {:.6g}{}{}", record.step, record.t, end_, time_left_);
  if (record.motion && record.newton_iterations == 0 && record.motion->time == record.t) {
    const std::string broken = record.fracture
                                   ? fmt::format("{}, {}, ", plural(record.fracture->broken_bonds, "broken bond"),
                                                 plural(record.fracture->fragments, "fragment"))
                                   : "";
    print(fmt::format("  row {} at t = {:.6g}: {} time steps, kinetic {:.4g}, stored {:.4g}, {}{}{}\n", record.step,
                      record.t, record.motion->time_steps, record.motion->kinetic_energy, record.stored_energy, broken,
                      duration(record.seconds), left));
    return;
  }
  print(fmt::format("  committed step {} at t = {:.6g}: {}, {}, {}{}\n", record.step, record.t,
                    plural(record.newton_iterations, "Newton iteration"),
                    plural(record.linear_iterations, "linear iteration"), duration(record.seconds), left));
}

}  // namespace perinox::output
