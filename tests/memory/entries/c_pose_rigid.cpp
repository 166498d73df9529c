// flashbvh_pose_rigid().
#include "memory/arguments.hpp"

extern "C" void c_pose_rigid(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  in.status = static_cast<uint8_t>(flashbvh_pose_rigid(
      in.rotation[0], in.cells, in.fraction, reinterpret_cast<flashbvh_pose*>(in.made_pose.bytes)));
}
