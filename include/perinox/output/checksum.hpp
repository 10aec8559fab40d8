#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"

namespace perinox::output {

/// A sum over 8-byte words, each scrambled with its own number: sum_k mix(w_k + c (k + 1)) mod 2^64, where mix is the
/// finaliser of splitmix64, a one-to-one map. Any change within one word changes the sum for certain, any other change
/// fails to do so with probability 2^-64. Shares of a file add up, whichever rank computes them. The last word is
/// filled up with zeros. bytes: a multiple of 8, except in the last share. first_word: number of the first of these
/// words in the whole.
std::uint64_t checksum(const void* data, std::size_t bytes, std::uint64_t first_word = 0);

/// A range of bytes of a file, a multiple of 8 behind `begin` of file_checksum, and the part of its checksum that a
/// rank knows.
struct KnownShare {
  std::uint64_t begin, end, checksum;
};

/// Checksum of the bytes [begin, end) of a file, with words counted from `begin`. Each rank reads a share. known:
/// ranges in ascending order, the same ones on every rank. These are not read; the ranks' sums for them are added
/// instead. Returns the same on every rank. Collective. Throws RunError if the file cannot be read that far.
std::uint64_t file_checksum(const std::string& path, std::uint64_t begin, std::uint64_t end,
                            const Communicator& communicator, const std::vector<KnownShare>& known = {});

/// The value as sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t value);

}  // namespace perinox::output
