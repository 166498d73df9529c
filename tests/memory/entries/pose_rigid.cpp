// Pose::rigid() of integers.
#include "flashbvh/pose.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void pose_rigid(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  memory::make_in<Pose>(in.made_pose, [&] {
    const auto& rotation = *reinterpret_cast<const int32_t(*)[3][3]>(in.rotation);
    const auto& cells = *reinterpret_cast<const int32_t(*)[3]>(in.cells);
    return Pose::rigid(rotation, cells, *reinterpret_cast<const int16_t(*)[3]>(in.fraction));
  });
}
