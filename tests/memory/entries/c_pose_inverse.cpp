// flashbvh_pose_inverse().
#include "memory/arguments.hpp"

extern "C" void c_pose_inverse(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(
      flashbvh_pose_inverse(in.c_pose, reinterpret_cast<flashbvh_pose*>(in.made_pose.bytes)));
}
