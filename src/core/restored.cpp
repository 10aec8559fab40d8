#include "perinox/core/restored.hpp"

#include <fmt/format.h>

#include <cmath>

namespace perinox {

long long restored_integer(const StateReader& reader, const std::string& name, long long least, long long most) {
  const long long value = reader.integer(name);
  reader.refuse_if(value >= least && value <= most
                       ? std::string()
                       : fmt::format("its {} is {}, which is not between {} and {}", name, value, least, most));
  return value;
}

int restored_count(const StateReader& reader, const std::string& name, int most) {
  return static_cast<int>(restored_integer(reader, name, 0, most));
}

double restored_number(const StateReader& reader, const std::string& name, double least) {
  const double value = reader.number(name);
  reader.refuse_if(std::isfinite(value) && value >= least
                       ? std::string()
                       : fmt::format("its {} is {}, which is not a number of at least {}", name, value, least));
  return value;
}

}  // namespace perinox
