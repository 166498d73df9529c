// flashbvh_pose_composed().
#include "memory/arguments.hpp"

extern "C" void c_pose_composed(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(flashbvh_pose_composed(
      in.c_pose, in.c_other_pose, reinterpret_cast<flashbvh_pose*>(in.made_pose.bytes)));
}
