#pragma once
#include <string>

#include "perinox/core/communicator.hpp"
#include "perinox/core/error.hpp"

namespace perinox::body {

/// Runs `work` on every rank. If it throws InputError on any of them, every rank throws the sentence of the lowest such
/// rank. `work` itself must not communicate. Collective.
template <class Work>
void together(const Communicator& communicator, Work&& work) {
  std::string sentence;
  try {
    work();
  } catch (const InputError& error) {
    sentence = error.what();
  }
  communicator.agree_on_input_error(sentence);
}

/// Throws the `sentence` of the rank with the smallest `order` (a particle's id, a file's line) on every rank. A rank
/// with nothing to refuse passes an empty sentence. The sentence that is thrown therefore does not depend on the number
/// of ranks. Collective.
void refuse_first(const Communicator& communicator, long long order, const std::string& sentence);

}  // namespace perinox::body
