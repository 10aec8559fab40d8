#pragma once
#include <string>

#include "perinox/core/profile.hpp"

namespace perinox::output {

/// The seconds of a run, section by section, with their share of the wall time and how often each was entered, the
/// longest first; sections never entered are left out. Lines that end in a newline.
std::string profile_table(const ProfileReading& reading);

}  // namespace perinox::output
