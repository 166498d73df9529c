// The C interface to poses.
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_ROTATION_ONE == kRotationOne, "one meaning of one");
static_assert(FLASHBVH_MAX_TRANSLATION == kMaxTranslation, "one range of translations");

flashbvh_status flashbvh_pose_translated(int32_t x, int32_t y, int32_t z, flashbvh_pose* pose) {
  return put_pose(Pose::translated(x, y, z), pose);
}

flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose) {
  const int16_t none[3] = {0, 0, 0};
  return put_pose(Pose::rigid(array_in<int32_t[3][3]>(rotation), array_in<int32_t[3]>(cells),
                              array_in<int16_t[3]>(fraction == nullptr ? none : fraction)),
                  pose);
}

flashbvh_status flashbvh_pose_composed(const flashbvh_pose* outer, const flashbvh_pose* inner,
                                       flashbvh_pose* pose) {
  return put_pose(Pose::composed(object_in(outer), object_in(inner)), pose);
}

flashbvh_status flashbvh_pose_inverse(const flashbvh_pose* pose, flashbvh_pose* inverse) {
  return put_pose(object_in(pose).inverse(), inverse);
}

flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose) {
  return put_pose(Pose::relative(object_in(world_a), object_in(world_b)), pose);
}

flashbvh_status flashbvh_pose_status(const flashbvh_pose* pose) {
  return c_status(object_in(pose).status());
}

void flashbvh_pose_values(const flashbvh_pose* pose, int32_t rotation[9], int32_t cells[3],
                          int16_t fraction[3]) {
  const Pose& values = object_in(pose);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; rotation != nullptr && j < 3; ++j) {
      rotation[3 * i + j] = values.rotation(i, j);
    }
    if (cells != nullptr) {
      cells[i] = values.translation(i);
    }
    if (fraction != nullptr) {
      fraction[i] = static_cast<int16_t>(values.fraction(i));
    }
  }
}
