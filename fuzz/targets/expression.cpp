#include "perinox/deck/expression.hpp"

#include <cmath>

#include "../targets.hpp"
#include "accepted.hpp"

namespace perinox::fuzz {

namespace {
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }
}  // namespace

bool expression(const std::string& input) {
  return accepted([&] {
    const deck::Location where{"fuzz.yaml", 1, 1};
    const deck::Expression formula(input, where), again(formula.text(), where);
    for (const double x : {0.0, -1.0, 1e300, 0.37})
      for (const double t : {0.0, 1.0}) {
        const double value = formula(x, 2 * x, -x, t);
        demand(same(value, formula(x, 2 * x, -x, t)), "a formula without a definite value");
        demand(same(value, again(x, 2 * x, -x, t)), "a formula that changes when read again");
        demand(formula.uses_time() || same(value, formula(x, 2 * x, -x, 0.5)), "a formula that uses t and denies it");
      }
  });
}

}  // namespace perinox::fuzz
