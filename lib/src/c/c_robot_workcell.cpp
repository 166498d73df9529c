// The C interface to workcells.
#include "flashbvh/robot.h"
#include "flashbvh/robot/workcell.hpp"
#include "objects.hpp"

using namespace flashbvh;

FLASHBVH_HOLDS(flashbvh_workcell, Workcell);

static_assert(FLASHBVH_WORKCELL_SIZE(1, 1, 1, 1) == sizeof(WorkcellOf<1, 1, 1, 1>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 1, 1, 2) == sizeof(WorkcellOf<3, 1, 1, 2>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 4, 1, 2) == sizeof(WorkcellOf<3, 4, 1, 2>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 4, 5, 9) == sizeof(WorkcellOf<3, 4, 5, 9>),
              "one size of a memory");

flashbvh_status flashbvh_workcell_init(flashbvh_workcell* workcell, const flashbvh_robot* robot,
                                       void* memory, size_t size,
                                       const flashbvh_workcell_room* room) {
  return c_status(make_in_place(workcell, *robot, memory, size, *room).status());
}

const flashbvh_robot* flashbvh_workcell_robot(const flashbvh_workcell* workcell) {
  return &object_in(workcell).robot();
}

flashbvh_status flashbvh_workcell_add(flashbvh_workcell* workcell, const flashbvh_mesh* mesh,
                                      const flashbvh_mount* mount, uint8_t* link) {
  return c_status(object_in(workcell).add(object_in(mesh), *mount, *link));
}

flashbvh_status flashbvh_workcell_keep_apart(flashbvh_workcell* workcell, uint8_t a, uint8_t b,
                                             flashbvh_fine_length stop, flashbvh_fine_length warn) {
  return c_status(object_in(workcell).keep_apart(a, b, stop, warn));
}

flashbvh_status flashbvh_workcell_move(flashbvh_workcell* workcell, uint8_t link,
                                       const flashbvh_frame* frame, flashbvh_fine_length moved) {
  return c_status(object_in(workcell).move(link, *frame, moved));
}
