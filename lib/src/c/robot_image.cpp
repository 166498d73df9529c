// The C interface to robots' images.
#include "flashbvh/robot/image.hpp"
#include "robot_objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_open_robot(const void* image, size_t size, flashbvh_mesh* meshes,
                                    uint32_t mesh_capacity, flashbvh_robot* robot) {
  return c_status(open_robot(image, size, reinterpret_cast<PostMesh*>(meshes), mesh_capacity,
                             *reinterpret_cast<Robot*>(robot)));
}

const char* flashbvh_robot_name(const void* image) {
  return robot_name(image);
}

const char* flashbvh_joint_name(const void* image, uint32_t joint) {
  return joint_name(image, joint);
}

const char* flashbvh_link_name(const void* image, uint32_t link) {
  return link_name(image, link);
}

uint32_t flashbvh_mount_count(const void* image) {
  return mount_count(image);
}

const flashbvh_mount* flashbvh_mounts(const void* image) {
  return reinterpret_cast<const flashbvh_mount*>(mounts(image));
}

const char* flashbvh_mount_name(const void* image, uint32_t mount) {
  return mount_name(image, mount);
}

uint32_t flashbvh_unguarded_count(const void* image) {
  return unguarded_count(image);
}

const flashbvh_robot_unguarded* flashbvh_unguarded_pairs(const void* image) {
  return reinterpret_cast<const flashbvh_robot_unguarded*>(unguarded_pairs(image));
}
