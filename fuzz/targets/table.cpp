#include <array>
#include <cmath>
#include <numeric>

#include "../targets.hpp"
#include "accepted.hpp"
#include "perinox/body/field_table.hpp"
#include "small_body.hpp"

namespace perinox::fuzz {

bool table(const std::string& input) {
  static MemoryFile file;
  file.put(input);
  bool any = false;
  for (const int dimension : {3, 2}) {
    const body::Body body = small_body(dimension);
    // All of the body, and a part of it: more of the tables are accepted then.
    for (const std::size_t count : {static_cast<std::size_t>(body.owned), std::size_t{1}}) {
      std::vector<LocalIndex> set(count);
      std::iota(set.begin(), set.end(), 0);
      any = accepted([&] {
              const body::FieldTable field(file.path(), {"fuzz.yaml", 1, 1}, body, set);
              demand(!field.times().empty(), "a table without a time");
              for (const double t : {0.0, 1e-9, 0.5, 1.0, field.times().front(), field.times().back()})
                for (std::size_t k = 0; k < set.size(); ++k) {
                  std::array<double, 3> u{};
                  field.evaluate(k, t, u.data());
                  for (const double component : u)
                    demand(std::isfinite(component), "a displacement that is not finite");
                }
            }) ||
            any;
    }
  }
  return any;
}

}  // namespace perinox::fuzz
