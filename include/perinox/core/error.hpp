#pragma once
#include <stdexcept>
#include <string>

namespace perinox {

/// The input is wrong. Nothing was run and the exit status is 2. The text is one sentence that says what to do; it
/// begins with `file:line:column: ` where a place in an input file is known.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The run stopped early. The last converged step is on disk and the exit status is 1. The text is the reason.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace perinox
