// The C interface to robots' float values; firmware without floats does not link it.
#include "flashbvh/robot.h"
#include "flashbvh/robot/robot_float.hpp"
#include "objects.hpp"

using namespace flashbvh;

void flashbvh_set_values(const flashbvh_robot* robot, const float* floats,
                         flashbvh_joint_coordinate* values) {
  set_values(*robot, floats, values);
}

flashbvh_status flashbvh_set_frame_of_matrix(const flashbvh_robot* robot, const float rotation[9],
                                             const float metres[3], flashbvh_frame* frame) {
  return c_status(
      set_frame(*robot, array_in<float[3][3]>(rotation), array_in<float[3]>(metres), *frame));
}
