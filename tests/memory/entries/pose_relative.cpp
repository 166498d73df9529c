// Pose::relative(): what a moving robot needs.
#include "flashbvh/pose.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_relative(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] { return Pose::relative(*in.pose, *in.other_pose); });
}
