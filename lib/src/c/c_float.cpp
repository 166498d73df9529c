// The C interface to floats; firmware without floats does not link it.
#include "flashbvh/float.hpp"
#include "objects.hpp"

using namespace flashbvh;

float flashbvh_mesh_cells_per_unit(const flashbvh_mesh* mesh) {
  return cells_per_unit(object_in(mesh).cell_bits);
}

flashbvh_status flashbvh_pose_of_matrix(const float rotation[9], const float translation[3],
                                        float cells_per_unit, flashbvh_pose* pose) {
  return put_pose(
      pose_of(array_in<float[3][3]>(rotation), array_in<float[3]>(translation), cells_per_unit),
      pose);
}

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
