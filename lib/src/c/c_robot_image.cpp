// The C interface to robots' images.
#include "flashbvh/robot.h"
#include "flashbvh/robot/image.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(sizeof(Mesh) == sizeof(flashbvh_mesh) && alignof(Mesh) == alignof(flashbvh_mesh),
              "an array of flashbvh_mesh holds as many meshes");

static_assert(FLASHBVH_FULL_TURN == kFullTurn && FLASHBVH_NO_COORDINATE == kNoCoordinate &&
                  FLASHBVH_FRAME_BITS == kFrameBits && FLASHBVH_REACH_BITS == kReachBits &&
                  FLASHBVH_BASE == kBase,
              "one meaning of numbers");

namespace {

void put_count(uint32_t number, uint32_t* count) {
  if (count != nullptr) {
    *count = number;
  }
}

}  // namespace

flashbvh_status flashbvh_open_robot(const void* image, size_t size, flashbvh_mesh* meshes,
                                    uint32_t mesh_capacity, flashbvh_robot* robot) {
  return c_status(open_robot(image, size, &object_in(meshes), mesh_capacity, *robot));
}

void flashbvh_view_robot_unchecked(const void* image, flashbvh_mesh* meshes,
                                   flashbvh_robot* robot) {
  put(robot, [&] { return view_robot_unchecked(image, &object_in(meshes)); });
}

const char* flashbvh_joint_name(const void* image, uint32_t joint) {
  return joint_name(image, joint);
}

const char* flashbvh_link_name(const void* image, uint32_t link) {
  return link_name(image, link);
}

const flashbvh_mount* flashbvh_mounts(const void* image, uint32_t* count) {
  put_count(mount_count(image), count);
  return mounts(image);
}

const flashbvh_robot_unguarded* flashbvh_unguarded_pairs(const void* image, uint32_t* count) {
  put_count(unguarded_count(image), count);
  return unguarded_pairs(image);
}
