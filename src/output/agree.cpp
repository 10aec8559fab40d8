#include "agree.hpp"

#include "perinox/core/error.hpp"

namespace perinox::output {

void agree_on_run_error(const Communicator& communicator, const std::string& sentence) {
  try {
    communicator.agree_on_input_error(sentence);
  } catch (const InputError& agreed) {
    throw RunError(agreed.what());
  }
}

}  // namespace perinox::output
