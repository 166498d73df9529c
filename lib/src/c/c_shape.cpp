// The C interface to shapes.
//
// A C struct begins with its shape's mesh, since a Shape begins with its mesh.
#include "flashbvh/shape.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_segment_shape, SegmentShape);
FLASHBVH_HOLDS(flashbvh_box_shape, BoxShape);

static_assert(__is_standard_layout(flashbvh_segment_shape), "its mesh is at its address");

flashbvh_status flashbvh_segment_shape_make(flashbvh_segment_shape* shape,
                                            const flashbvh_mesh* like, const flashbvh_point* p,
                                            const flashbvh_point* q) {
  return c_status(make_in_place(shape, object_in(like), *p, *q).status());
}

flashbvh_status flashbvh_box_shape_make(flashbvh_box_shape* shape, const flashbvh_mesh* like,
                                        const flashbvh_point* lower, const flashbvh_point* upper) {
  return c_status(make_in_place(shape, object_in(like), *lower, *upper).status());
}
