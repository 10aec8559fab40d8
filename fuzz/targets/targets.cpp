#include "../targets.hpp"

#include "accepted.hpp"

namespace perinox::fuzz {

const std::string& refusal() { return last_refusal; }

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"deck", deck}, {"cloud", cloud}, {"table", table}, {"expression", expression}, {"checkpoint", checkpoint}};
  return all;
}

}  // namespace perinox::fuzz
