#pragma once
/// The first 512 bytes of a checkpoint, HDF5's user block: text that says what the file is, how long, and its checksum.
#include <cstdint>
#include <string>

namespace perinox::output {

constexpr int seal_bytes = 512;
constexpr int checkpoint_format = 1;

/// bytes: of the whole file, the seal included; checksum: of all behind the seal.
std::string seal_text(std::uint64_t bytes, std::uint64_t checksum, int format = checkpoint_format);

/// The reason why a file is none of ours or not whole as a sentence about `path`, or "". head: its first seal_bytes
/// bytes, or as many as there are; bytes: of the whole file. On success `checksum` is the one its content must have.
std::string read_seal(const std::string& path, const std::string& head, std::uint64_t bytes, std::uint64_t& checksum);

}  // namespace perinox::output
