// The C interface to robots' float values; firmware without floats does not link it.
#include "flashbvh/robot.h"
#include "flashbvh/robot/robot_float.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_joint_coordinate flashbvh_angle_coordinate(float radians) {
  return angle_coordinate(radians);
}

flashbvh_joint_coordinate flashbvh_slide_coordinate(float length, float cells_per_unit) {
  return slide_coordinate(length, cells_per_unit);
}

void flashbvh_set_values(const flashbvh_robot* robot, const float* floats,
                         flashbvh_joint_coordinate* values) {
  set_values(*robot, floats, values);
}

flashbvh_status flashbvh_set_frame_of_matrix(const flashbvh_robot* robot, const float rotation[9],
                                             const float metres[3], flashbvh_frame* frame) {
  return c_status(
      set_frame(*robot, array_in<float[3][3]>(rotation), array_in<float[3]>(metres), *frame));
}

flashbvh_status flashbvh_set_frame_of_quaternion(const flashbvh_robot* robot,
                                                 const float rotation[4], const float metres[3],
                                                 flashbvh_frame* frame) {
  const UnitQuaternion q = {rotation[0], rotation[1], rotation[2], rotation[3]};
  return c_status(set_frame(*robot, q, array_in<float[3]>(metres), *frame));
}
