// What firmware compiles that makes poses of floats: check_symbols.cmake looks at what it calls.
#include "flashbvh/pose_float.hpp"

namespace flashbvh::test {

Pose pose_of_rows(const float (&matrix)[3][4], float cells_per_unit) {
  return pose_of(matrix, cells_per_unit);
}

Pose pose_of_matrix(const float (&rotation)[3][3], const float (&translation)[3], float scale) {
  return pose_of(rotation, translation, scale);
}

Pose pose_of_quaternion(const UnitQuaternion& q, const float (&translation)[3], float scale) {
  return pose_of(q, translation, scale);
}

}  // namespace flashbvh::test
