// The C interface to robots' arrays and kinematics.
#include "flashbvh/robot/kinematics.hpp"

#include "robot_objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_FULL_TURN == kFullTurn && FLASHBVH_NO_COORDINATE == kNoCoordinate &&
                  FLASHBVH_FRAME_BITS == kFrameBits && FLASHBVH_REACH_BITS == kReachBits &&
                  FLASHBVH_BASE == kBase,
              "one meaning of numbers");
static_assert(FLASHBVH_JOINT_CONTINUOUS == static_cast<int>(JointType::continuous) &&
                  FLASHBVH_JOINT_PRISMATIC == static_cast<int>(JointType::prismatic) &&
                  FLASHBVH_JOINT_FIXED == static_cast<int>(JointType::fixed),
              "one list of joints");

FLASHBVH_SAME_SIZE(Frame, flashbvh_frame);
FLASHBVH_SAME_PLACE(Frame, flashbvh_frame, translation);

FLASHBVH_SAME_SIZE(Mount, flashbvh_mount);
FLASHBVH_SAME_PLACE(Mount, flashbvh_mount, frame);

FLASHBVH_SAME_SIZE(RobotJoint, flashbvh_robot_joint);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, lower);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, upper);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, multiplier);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, offset);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, shift);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, parent);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, variable);
FLASHBVH_SAME_PLACE(RobotJoint, flashbvh_robot_joint, type);

FLASHBVH_SAME_SIZE(RobotLink, flashbvh_robot_link);
FLASHBVH_SAME_PLACE(RobotLink, flashbvh_robot_link, radius);
FLASHBVH_SAME_PLACE(RobotLink, flashbvh_robot_link, first_reach);
FLASHBVH_SAME_PLACE(RobotLink, flashbvh_robot_link, joint);

FLASHBVH_SAME_SIZE(RobotPair, flashbvh_robot_pair);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, warn);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, reach);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, a);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, b);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, joints_a);
FLASHBVH_SAME_PLACE(RobotPair, flashbvh_robot_pair, joints_b);

FLASHBVH_SAME_SIZE(RobotUnguarded, flashbvh_robot_unguarded);
FLASHBVH_SAME_PLACE(RobotUnguarded, flashbvh_robot_unguarded, why);

FLASHBVH_SAME_SIZE(Robot, flashbvh_robot);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, links);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, meshes);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, pairs);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, reaches);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, charts);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, joint_count);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, link_count);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, variable_count);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, pair_count);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, reach_count);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, slack);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, chart_bytes);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, hash);
FLASHBVH_SAME_PLACE(Robot, flashbvh_robot, cell_bits);

// Mesh has a base, and offsetof() does not tell of its fields: tests/c_api/robot_reference.cpp
// does.
FLASHBVH_SAME_SIZE(PostMesh, flashbvh_mesh);
FLASHBVH_SAME_SIZE(PostMesh, flashbvh_mesh_view);

flashbvh_status flashbvh_set_coordinates(const flashbvh_robot* robot,
                                         const flashbvh_joint_coordinate* values,
                                         flashbvh_joint_coordinate* coordinates) {
  return c_status(set_coordinates(object_in(robot), values, coordinates));
}

void flashbvh_set_frames(const flashbvh_robot* robot, const flashbvh_joint_coordinate* coordinates,
                         flashbvh_frame* frames) {
  set_frames(object_in(robot), coordinates, &object_in(frames));
}

void flashbvh_frame_composed(const flashbvh_frame* outer, const flashbvh_frame* inner,
                             flashbvh_frame* frame) {
  object_in(frame) = composed(object_in(outer), object_in(inner));
}

flashbvh_status flashbvh_relative_pose(const flashbvh_frame* a, const flashbvh_frame* b,
                                       flashbvh_pose* pose) {
  return put_pose(relative_pose(object_in(a), object_in(b)), pose);
}
