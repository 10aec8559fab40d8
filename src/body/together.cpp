#include "perinox/body/together.hpp"

#include <limits>

namespace perinox::body {

void refuse_first(const Communicator& communicator, long long order, const std::string& sentence) {
  const long long none = std::numeric_limits<long long>::max();
  const long long mine = sentence.empty() ? none : order;
  const long long first = -communicator.max(-mine);
  communicator.agree_on_input_error(mine == first ? sentence : std::string());
}

}  // namespace perinox::body
