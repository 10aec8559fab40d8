#include "perinox/core/profile.hpp"

#include <algorithm>
#include <numeric>

namespace perinox {

const char* name_of(Section section) {
  constexpr const char* names[section_count] = {"product", "preconditioner", "halo",  "assembly",
                                                "force",   "linearise",      "output"};
  return names[static_cast<std::size_t>(section)];
}

double ProfileReading::rest() const {
  return std::max(0.0, wall - std::accumulate(seconds.begin(), seconds.end(), 0.0));
}

ProfileReading operator-(const ProfileReading& later, const ProfileReading& earlier) {
  ProfileReading between;
  for (std::size_t s = 0; s < section_count; ++s) {
    between.count[s] = later.count[s] - earlier.count[s];
    between.seconds[s] = later.seconds[s] - earlier.seconds[s];
  }
  between.wall = later.wall - earlier.wall;
  return between;
}

Profile::Profile() : begin_(Clock::now()), change_(begin_) { open_.reserve(8); }

double Profile::since_change(Clock::time_point now) const {
  return std::chrono::duration<double>(now - change_).count();
}

void Profile::open(Section section) {
  const Clock::time_point now = Clock::now();
  if (!open_.empty()) seconds_[open_.back()] += since_change(now);
  const auto number = static_cast<std::size_t>(section);
  open_.push_back(number);
  ++count_[number];
  change_ = now;
}

void Profile::close() {
  const Clock::time_point now = Clock::now();
  seconds_[open_.back()] += since_change(now);
  open_.pop_back();
  change_ = now;
}

ProfileReading Profile::read() const {
  const Clock::time_point now = Clock::now();
  ProfileReading reading;
  reading.count = count_;
  reading.seconds = seconds_;
  if (!open_.empty()) reading.seconds[open_.back()] += since_change(now);
  reading.wall = std::chrono::duration<double>(now - begin_).count();
  return reading;
}

}  // namespace perinox
