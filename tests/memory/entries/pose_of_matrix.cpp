// A pose of a matrix of floats.
#include "flashbvh/pose_float.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_of_matrix(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] {
    return pose_of(*reinterpret_cast<const float(*)[3][4]>(in.floats), 1.0f);
  });
}
