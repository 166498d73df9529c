// Names of statuses, in a file of its own: firmware that never prints them does not link the text.
#include "flashbvh/status.hpp"

using namespace flashbvh;

#define FLASHBVH_CASE(name) \
  case Status::name:        \
    return #name

// No default case, so that the compiler reports a status without a name.
const char* flashbvh_status_name(flashbvh_status status) {
  switch (static_cast<Status>(status)) {
    FLASHBVH_CASE(done);
    FLASHBVH_CASE(suspended);
    FLASHBVH_CASE(full);
    FLASHBVH_CASE(cell_mismatch);
    FLASHBVH_CASE(stack_too_small);
    FLASHBVH_CASE(translation_out_of_range);
    FLASHBVH_CASE(not_a_rotation);
    FLASHBVH_CASE(cursor_invalid);
    FLASHBVH_CASE(hint_invalid);
    FLASHBVH_CASE(distance_out_of_range);
    FLASHBVH_CASE(not_closed);
    FLASHBVH_CASE(shape_too_large);
    FLASHBVH_CASE(ray_out_of_range);
    FLASHBVH_CASE(not_a_coordinate);
    FLASHBVH_CASE(joint_out_of_limits);
    FLASHBVH_CASE(joint_jumped);
    FLASHBVH_CASE(guard_state_invalid);
    FLASHBVH_CASE(workcell_full);
    FLASHBVH_CASE(link_invalid);
    FLASHBVH_CASE(image_truncated);
    FLASHBVH_CASE(image_misaligned);
    FLASHBVH_CASE(image_not_flashbvh);
    FLASHBVH_CASE(image_version);
    FLASHBVH_CASE(image_kind);
    FLASHBVH_CASE(image_corrupt);
    FLASHBVH_CASE(image_invalid);
    FLASHBVH_CASE(image_too_large);
    FLASHBVH_CASE(vertex_out_of_lattice);
    FLASHBVH_CASE(mesh_changed);
    FLASHBVH_CASE(motion_out_of_range);
    FLASHBVH_CASE(self_test_failed);
    FLASHBVH_CASE(not_open);
  }
  return "unknown";
}
