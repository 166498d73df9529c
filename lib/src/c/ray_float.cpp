// The C interface to rays of floats: apart, for firmware that has none.
#include "flashbvh/ray_float.hpp"

#include "flashbvh/ray.h"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_segment_of(const float origin[3], const float direction[3], float reach,
                                    float cells_per_unit, flashbvh_segment* segment) {
  const MadeSegment made =
      segment_of({origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]},
                 reach, cells_per_unit);
  if (made.status == Status::done) {
    const Point& from = made.segment.from;
    const Point& to = made.segment.to;
    *segment = {{from.x, from.y, from.z}, {to.x, to.y, to.z}};
  }
  return c_status(made.status);
}
