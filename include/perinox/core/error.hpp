#pragma once
#include <stdexcept>
#include <string>

namespace perinox {

/// The input is wrong: nothing was run, exit status 2. The text is one sentence, prefixed with
/// `file:line:column: ` where a place in an input file is known, and says what to do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run stopped short: the last converged step is on disk, exit status 1. The text is the reason.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace perinox
