// The C interface to robots' kinematics.
#include "flashbvh/robot.h"
#include "flashbvh/robot/kinematics.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_FULL_TURN == kFullTurn && FLASHBVH_NO_COORDINATE == kNoCoordinate &&
                  FLASHBVH_FRAME_BITS == kFrameBits && FLASHBVH_REACH_BITS == kReachBits &&
                  FLASHBVH_BASE == kBase,
              "one meaning of numbers");

flashbvh_status flashbvh_set_coordinates(const flashbvh_robot* robot,
                                         const flashbvh_joint_coordinate* values,
                                         flashbvh_joint_coordinate* coordinates) {
  return c_status(set_coordinates(*robot, values, coordinates));
}

void flashbvh_set_frames(const flashbvh_robot* robot, const flashbvh_joint_coordinate* coordinates,
                         flashbvh_frame* frames) {
  set_frames(*robot, coordinates, frames);
}

void flashbvh_frame_composed(const flashbvh_frame* outer, const flashbvh_frame* inner,
                             flashbvh_frame* frame) {
  *frame = composed(*outer, *inner);
}

flashbvh_status flashbvh_relative_pose(const flashbvh_frame* a, const flashbvh_frame* b,
                                       flashbvh_pose* pose) {
  return put_pose(relative_pose(*a, *b), pose);
}
