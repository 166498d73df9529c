// The C interface to shapes.
//
// A C struct begins with the mesh that its shape shows, since a Shape begins with its mesh.
#include "flashbvh/shape.hpp"

#include "flashbvh/shape.h"
#include "objects.hpp"

using namespace flashbvh;

namespace {

Point corner_of(const flashbvh_point& p) {
  return {p.x, p.y, p.z};
}

template <class Made, class Struct, class... Corners>
flashbvh_status make_shape(Struct* shape, const flashbvh_mesh* like, const Corners&... corners) {
  static_assert(sizeof(Made) <= sizeof(Struct), "the struct in shape.h is too small");
  static_assert(alignof(Made) <= alignof(Struct), "the struct in shape.h is not aligned");
  static_assert(__is_standard_layout(Struct), "its mesh is at its address");
  static_assert(__has_trivial_destructor(Made), "C drops its structs as bytes");
  auto* const made =
      new (Storage{reinterpret_cast<unsigned char*>(shape)}) Made(object_in(like), corners...);
  return c_status(made->status());
}

}  // namespace

flashbvh_status flashbvh_point_shape_make(flashbvh_point_shape* shape, const flashbvh_mesh* like,
                                          const flashbvh_point* at) {
  return make_shape<PointShape>(shape, like, corner_of(*at));
}

flashbvh_status flashbvh_segment_shape_make(flashbvh_segment_shape* shape,
                                            const flashbvh_mesh* like, const flashbvh_point* p,
                                            const flashbvh_point* q) {
  return make_shape<SegmentShape>(shape, like, corner_of(*p), corner_of(*q));
}

flashbvh_status flashbvh_triangle_shape_make(flashbvh_triangle_shape* shape,
                                             const flashbvh_mesh* like,
                                             const flashbvh_triangle* triangle) {
  const auto& corner = triangle->corner;
  const Triangle corners = {{corner_of(corner[0]), corner_of(corner[1]), corner_of(corner[2])}};
  return make_shape<TriangleShape>(shape, like, corners);
}

flashbvh_status flashbvh_box_shape_make(flashbvh_box_shape* shape, const flashbvh_mesh* like,
                                        const flashbvh_point* lower, const flashbvh_point* upper) {
  return make_shape<BoxShape>(shape, like, corner_of(*lower), corner_of(*upper));
}
