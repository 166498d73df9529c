// The C interface to workcells.
#include "flashbvh/robot/workcell.hpp"

#include "robot_objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_WORKCELL_SIZE(1, 1, 1, 1) == sizeof(WorkcellOf<1, 1, 1, 1>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 1, 1, 2) == sizeof(WorkcellOf<3, 1, 1, 2>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 4, 1, 2) == sizeof(WorkcellOf<3, 4, 1, 2>) &&
                  FLASHBVH_WORKCELL_SIZE(3, 4, 5, 9) == sizeof(WorkcellOf<3, 4, 5, 9>),
              "one size of a memory");

namespace {

Workcell& workcell_in(flashbvh_workcell* workcell) {
  return *reinterpret_cast<Workcell*>(workcell->opaque.bytes);
}

}  // namespace

flashbvh_status flashbvh_workcell_init(flashbvh_workcell* workcell, const flashbvh_robot* robot,
                                       void* memory, size_t size,
                                       const flashbvh_workcell_room* room) {
  static_assert(sizeof(Workcell) <= sizeof(flashbvh_workcell) &&
                    alignof(Workcell) <= alignof(flashbvh_workcell),
                "the struct in robot.h is too small");
  new (Storage{workcell->opaque.bytes}) Workcell(
      object_in(robot), memory, size, {room->joints, room->links, room->pairs, room->reaches});
  return c_status(workcell_in(workcell).fits() ? Status::done : Status::workcell_full);
}

const flashbvh_robot* flashbvh_workcell_robot(const flashbvh_workcell* workcell) {
  const auto& made = *reinterpret_cast<const Workcell*>(workcell->opaque.bytes);
  return reinterpret_cast<const flashbvh_robot*>(&made.robot());
}

flashbvh_status flashbvh_workcell_add(flashbvh_workcell* workcell, const flashbvh_mesh* mesh,
                                      const flashbvh_mount* mount, uint8_t* link) {
  return c_status(
      workcell_in(workcell).add(object_in(mesh), *reinterpret_cast<const Mount*>(mount), *link));
}

flashbvh_status flashbvh_workcell_keep_apart(flashbvh_workcell* workcell, uint8_t a, uint8_t b,
                                             uint32_t stop, uint32_t warn) {
  return c_status(workcell_in(workcell).keep_apart(a, b, stop, warn));
}

flashbvh_status flashbvh_workcell_move(flashbvh_workcell* workcell, uint8_t link,
                                       const flashbvh_frame* frame, uint32_t moved) {
  return c_status(workcell_in(workcell).move(link, object_in(frame), moved));
}
