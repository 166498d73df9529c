// The robot layer's plain structs: those of robot.h have the layout of those of C++, so each is
// read as the other where it lies.
#ifndef FLASHBVH_C_ROBOT_OBJECTS_HPP
#define FLASHBVH_C_ROBOT_OBJECTS_HPP

#include <stddef.h>

#include "flashbvh/robot.h"
#include "flashbvh/robot/robot.hpp"
#include "objects.hpp"

namespace flashbvh {

// As many bytes, as aligned, and the field where it is.
#define FLASHBVH_SAME_SIZE(Cpp, C)                                                            \
  static_assert(                                                                              \
      sizeof(Cpp) == sizeof(C) && alignof(Cpp) == alignof(C) && __is_trivially_copyable(Cpp), \
      "robot.h has another layout")
#define FLASHBVH_SAME_PLACE(Cpp, C, field) \
  static_assert(offsetof(Cpp, field) == offsetof(C, field), "robot.h has another layout")

inline const Robot& object_in(const flashbvh_robot* robot) {
  return *reinterpret_cast<const Robot*>(robot);
}
inline const Frame& object_in(const flashbvh_frame* frame) {
  return *reinterpret_cast<const Frame*>(frame);
}
inline Frame& object_in(flashbvh_frame* frame) {
  return *reinterpret_cast<Frame*>(frame);
}

}  // namespace flashbvh

#endif
