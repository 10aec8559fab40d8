#pragma once
#include <string>

#include "perinox/core/profile.hpp"

namespace perinox::output {

/// A table of the seconds of a run, section by section, with their share of the wall time and how often each was
/// entered. The longest section comes first; sections never entered are left out. Every line ends in a newline.
std::string profile_table(const ProfileReading& reading);

}  // namespace perinox::output
