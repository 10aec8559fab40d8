#include "perinox/body/body.hpp"

namespace perinox::body {

deck::Point Body::position3(LocalIndex i) const {
  const double* x = position(i);
  return {x[0], x[1], dimension == 3 ? x[2] : 0.0};
}

}  // namespace perinox::body
