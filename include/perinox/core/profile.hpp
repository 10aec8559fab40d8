#pragma once
/// Measures where the wall time of a run goes, by named sections.
#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

namespace perinox {

/// The sections that are timed. Time outside all of them (vector updates and reductions of the Krylov method, NOX) is
/// the rest.
enum class Section {
  product,         ///< tangent times vector, matrix-free or sparse
  preconditioner,  ///< set-up and application
  halo,            ///< exchange between owners and ghosts, waiting for the other rank included
  assembly,        ///< values of the sparse matrix
  force,           ///< internal force with return mapping
  linearise,       ///< what the products and the preconditioner need of the state
  output           ///< files and terminal
};
constexpr std::size_t section_count = 7;
/// Name of a section ("product", ...), with which the name of its column in history.csv ends.
const char* name_of(Section section);

/// Counts and seconds of every section. The difference of two readings is what happened between them.
struct ProfileReading {
  std::array<long long, section_count> count{};
  std::array<double, section_count> seconds{};
  double wall = 0;  ///< time since the profile was made; in a difference: time between the two readings

  long long count_of(Section section) const { return count[static_cast<std::size_t>(section)]; }
  double seconds_of(Section section) const { return seconds[static_cast<std::size_t>(section)]; }
  /// Wall time spent in no section; it is never below 0.
  double rest() const;
};
ProfileReading operator-(const ProfileReading& later, const ProfileReading& earlier);

/// The stop watches of this rank. Time belongs to the innermost open section alone: a halo exchange inside a product
/// counts as halo and is left out of product. The sections of a reading therefore never add up to more than the wall
/// time. Opening and closing a section cost one clock reading each (tens of nanoseconds). A profile is for one thread
/// and is not collective.
class Profile {
 public:
  Profile();

  /// Time from here to the end of the scope belongs to the section. A section opened inside it interrupts it.
  class Scope {
   public:
    Scope(Profile& profile, Section section) : profile_(profile) { profile_.open(section); }
    ~Scope() { profile_.close(); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Profile& profile_;
  };

  /// The counts and seconds up to now, open sections included.
  ProfileReading read() const;

 private:
  using Clock = std::chrono::steady_clock;
  void open(Section section);
  void close();
  /// Seconds since the last change of section. They belong to the innermost open one.
  double since_change(Clock::time_point now) const;

  Clock::time_point begin_, change_;
  std::vector<std::size_t> open_;  ///< innermost last
  std::array<long long, section_count> count_{};
  std::array<double, section_count> seconds_{};
};

}  // namespace perinox
