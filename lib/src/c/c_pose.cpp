// The C interface to poses.
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_ROTATION_ONE == kRotationOne, "one meaning of one");
static_assert(FLASHBVH_MAX_TRANSLATION == kMaxTranslation, "one range of translations");

flashbvh_status flashbvh_pose_rigid(const int32_t rotation[9], const int32_t cells[3],
                                    const int16_t fraction[3], flashbvh_pose* pose) {
  const int16_t none[3] = {0, 0, 0};
  return put_pose(Pose::rigid(array_in<int32_t[3][3]>(rotation), array_in<int32_t[3]>(cells),
                              array_in<int16_t[3]>(fraction == nullptr ? none : fraction)),
                  pose);
}

flashbvh_status flashbvh_pose_relative(const flashbvh_pose* world_a, const flashbvh_pose* world_b,
                                       flashbvh_pose* pose) {
  return put_pose(Pose::relative(object_in(world_a), object_in(world_b)), pose);
}
