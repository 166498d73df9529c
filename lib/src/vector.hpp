// Differences of placed points, which is all that exact tests multiply.
#ifndef FLASHBVH_SRC_VECTOR_HPP
#define FLASHBVH_SRC_VECTOR_HPP

#include "flashbvh/lattice.hpp"

namespace flashbvh {

/// In cells.
struct Vector {
  int32_t x;
  int32_t y;
  int32_t z;
};

inline Vector difference(const Point& to, const Point& from) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

}  // namespace flashbvh

#endif
