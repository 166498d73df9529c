// The C interface to rays of floats: apart, for firmware that has none.
#include "flashbvh/ray.h"
#include "flashbvh/ray_float.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_segment_of(const float origin[3], const float direction[3], float reach,
                                    float cells_per_unit, flashbvh_segment* segment) {
  const MadeSegment made =
      segment_of(array_in<float[3]>(origin), array_in<float[3]>(direction), reach, cells_per_unit);
  if (made.status == Status::done) {
    *segment = made.segment;
  }
  return c_status(made.status);
}
