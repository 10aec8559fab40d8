#pragma once
/// The seal of a checkpoint: its first 512 bytes, HDF5's user block. They are text that says what the file is, how
/// long, and its checksum.
#include <cstdint>
#include <string>

namespace perinox::output {

constexpr int seal_bytes = 512;
constexpr int checkpoint_format = 1;

/// Makes the text of a seal. bytes: length of the whole file, the seal included. checksum: that of all bytes behind the
/// seal.
std::string seal_text(std::uint64_t bytes, std::uint64_t checksum, int format = checkpoint_format);

/// Reads a seal. Returns a sentence about `path` that says why the file is no checkpoint or not whole, or "". head: its
/// first seal_bytes bytes, or as many as there are. bytes: length of the whole file. On success `checksum` is the one
/// that its content must have.
std::string read_seal(const std::string& path, const std::string& head, std::uint64_t bytes, std::uint64_t& checksum);

}  // namespace perinox::output
