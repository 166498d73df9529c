// The C interface to float poses and points; firmware without floats does not link it.
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

flashbvh_status flashbvh_pose_of_quaternion(const float rotation[4], const float translation[3],
                                            float cells_per_unit, flashbvh_pose* pose) {
  const UnitQuaternion q = {rotation[0], rotation[1], rotation[2], rotation[3]};
  return put_pose(pose_of(q, array_in<float[3]>(translation), cells_per_unit), pose);
}

void flashbvh_in_unit(const flashbvh_fine_point* point, const flashbvh_mesh* mesh, float at[3]) {
  const UnitPoint p = in_unit(*point, object_in(mesh).cell_bits);
  at[0] = p.x;
  at[1] = p.y;
  at[2] = p.z;
}
