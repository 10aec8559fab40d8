#pragma once
#include <string>

namespace perinox::output {

/// Has the disk set aside `bytes` beyond the end of the file (created if missing), so that writing them cannot run out
/// of room halfway; the file keeps its content. One rank calls it. Returns the reason as a sentence if there is no room
/// (the file is then as before), else "".
std::string reserve(const std::string& path, double bytes);

/// Brings a file or a directory to the disk. Returns the system's reason if it cannot, else "". One rank calls it.
std::string sync_to_disk(const std::string& path);

}  // namespace perinox::output
