#pragma once
#include "perinox/body/body.hpp"

namespace perinox::fuzz {

/// Particles at the corners of the unit cube, or of the unit square, in the order of their ids.
inline body::Body small_body(int dimension) {
  body::Body body;
  body.dimension = dimension;
  const int count = dimension == 3 ? 8 : 4;
  for (int i = 0; i < count; ++i) {
    body.id.push_back(i);
    for (int c = 0; c < dimension; ++c) body.reference.push_back((i >> c) & 1);
  }
  body.owned = count;
  body.total = count;
  body.volume.assign(static_cast<std::size_t>(count), 1.0);
  body.part.assign(static_cast<std::size_t>(count), 0);
  body.material.assign(static_cast<std::size_t>(count), 0);
  return body;
}

}  // namespace perinox::fuzz
