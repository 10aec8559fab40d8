#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "perinox/core/communicator.hpp"

namespace perinox::output {

/// A sum over 8-byte words, each scrambled with its own number: sum_k mix(w_k + c (k + 1)) mod 2^64, mix the finaliser
/// of splitmix64, one to one. Any change within one word changes it for certain, any other but for 2^-64; and shares of
/// a file add up whoever computes which. The last word is filled up with zeros.
/// bytes: a multiple of 8 but in the last share. first_word: number of the first of these words in the whole.
std::uint64_t checksum(const void* data, std::size_t bytes, std::uint64_t first_word = 0);

/// Some bytes of a file, a multiple of 8 behind `begin` of file_checksum, and what of their checksum a rank knows.
struct KnownShare {
  std::uint64_t begin, end, checksum;
};

/// Of the bytes [begin, end) of a file, words counted from `begin`; each rank reads a share. known: in ascending order,
/// of the same bytes on every rank: these are not read, the ranks' sums for them are added. Returns the same on every
/// rank; throws RunError if the file cannot be read that far. Collective.
std::uint64_t file_checksum(const std::string& path, std::uint64_t begin, std::uint64_t end,
                            const Communicator& communicator, const std::vector<KnownShare>& known = {});

/// Sixteen hexadecimal digits.
std::string hexadecimal(std::uint64_t value);

}  // namespace perinox::output
