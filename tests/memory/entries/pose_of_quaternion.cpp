// A pose of a unit quaternion of floats.
#include "flashbvh/pose_float.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_of_quaternion(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] {
    const float* const f = in.floats;
    return pose_of(UnitQuaternion{f[0], f[1], f[2], f[3]},
                   *reinterpret_cast<const float(*)[3]>(f + 4), 1.0f);
  });
}
