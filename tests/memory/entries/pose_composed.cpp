// Pose::composed().
#include "flashbvh/pose.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_composed(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] { return Pose::composed(*in.pose, *in.other_pose); });
}
