// Pose::inverse().
#include "flashbvh/pose.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_inverse(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] { return in.pose->inverse(); });
}
