#pragma once
#include <string>

namespace perinox::output {

/// Sets aside `bytes` on the disk beyond the end of the file (created if missing), so that writing them cannot run out
/// of room halfway. The file keeps its content. One rank calls it. Returns the reason as a sentence if there is no room
/// (the file is then as before), otherwise "".
std::string reserve(const std::string& path, double bytes);

/// Brings a file or a directory to the disk. Returns the system's reason if it cannot, otherwise "". One rank calls it.
std::string sync_to_disk(const std::string& path);

}  // namespace perinox::output
