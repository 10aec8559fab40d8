#include "../targets.hpp"

namespace perinox::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"deck", deck}, {"cloud", cloud}, {"table", table}, {"expression", expression}, {"checkpoint", checkpoint}};
  return all;
}

}  // namespace perinox::fuzz
