#pragma once
/// What is fuzzed: one function for every kind of file that perinox reads. Each of them takes any bytes, and either
/// accepts them or refuses them with a sentence; whatever else happens (another exception, a crash, a leak, a sentence
/// of two lines, an accepted value that the rest of the program could not stand) is a defect. libfuzzer.cpp calls them
/// with made-up bytes, tests/fuzz with the corpus.
#include <string>
#include <vector>

namespace perinox::fuzz {

/// True: accepted. False: refused with a sentence. MPI must be up.
using Run = bool (*)(const std::string& input);

bool deck(
    const std::string& input);  ///< read, checked, converted; materials and lattices set up; resolved and read back
bool cloud(const std::string& input);       ///< point cloud, in 3-D and in 2-D, and its neighbours counted
bool table(const std::string& input);       ///< displacement table of eight particles
bool expression(const std::string& input);  ///< formula, evaluated at a few places
/// 'F' and bytes: a whole checkpoint file. 'C' and bytes: a sealed HDF5 file with the names of a checkpoint, whose
/// types, shapes and values the bytes decide.
bool checkpoint(const std::string& input);

/// The sentence with which something was refused last.
const std::string& refusal();

struct Target {
  const char* name;  ///< also of its folder in the corpus
  Run run;
};
const std::vector<Target>& targets();

}  // namespace perinox::fuzz
