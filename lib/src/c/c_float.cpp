// The C interface to float lengths, rays and contacts; firmware without floats does not link it.
#include "flashbvh/clearance.h"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.h"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_fine_length flashbvh_fine_length_rounded_up(float length, float cells_per_unit) {
  return fine_length_rounded_up(length, cells_per_unit);
}

float flashbvh_length_in_unit(int64_t fine, const flashbvh_mesh* mesh) {
  return length_in_unit(fine, object_in(mesh).cell_bits);
}

flashbvh_status flashbvh_segment_of(const float origin[3], const float direction[3], float reach,
                                    float cells_per_unit, flashbvh_segment* segment) {
  const MadeSegment made =
      segment_of(array_in<float[3]>(origin), array_in<float[3]>(direction), reach, cells_per_unit);
  if (made.status == Status::done) {
    *segment = made.segment;
  }
  return c_status(made.status);
}

flashbvh_status flashbvh_first_contact(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                       const flashbvh_pose* pose, flashbvh_unit_contact* contact) {
  const UnitContact<uint16_t> found = first_contact(object_in(a), object_in(b), object_in(pose));
  *contact = {
      found.normal_a, found.normal_b, {found.ends[0], found.ends[1]}, found.triangles, found.yes};
  return c_status(found.status);
}
