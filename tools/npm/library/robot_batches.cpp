// The C interface to robots and guards, for robot.js: periods in batches.
#include "../../wasm.hpp"
#include "flashbvh/robot/image.hpp"

namespace batches {

/// The sizes of a mesh, a robot and a guard in bytes.
EXPORT const uint32_t* sizes() {
  static const uint32_t bytes[] = {sizeof(flashbvh_mesh), sizeof(flashbvh_robot),
                                   sizeof(flashbvh_guard)};
  return bytes;
}

/// The cell in metres.
EXPORT double cell(const flashbvh_robot* robot) {
  return wasm::length_of(robot->cell_bits);
}

/// Counts of values, links and pairs, and the bytes of a guard's state.
EXPORT const uint32_t* counts(const flashbvh::RobotImageHeader* image) {
  static uint32_t found[4];
  found[0] = image->variable_count;
  found[1] = image->link_count;
  found[2] = image->pair_count;
  found[3] =
      FLASHBVH_GUARD_STATE_SIZE(image->joint_count, image->pair_count, image->pair_joint_count);
  return found;
}

EXPORT const char* variable_name(const void* image, const flashbvh_robot* robot,
                                 uint32_t variable) {
  return flashbvh_joint_name(image, wasm::joint_of(*robot, variable));
}

/// Writes two links per pair.
EXPORT void links_of_pairs(const flashbvh_robot* robot, uint8_t* links) {
  for (uint32_t i = 0; i < robot->pair_count; ++i) {
    links[2 * i] = robot->pairs[i].a;
    links[2 * i + 1] = robot->pairs[i].b;
  }
}

EXPORT void values_of(const flashbvh_robot* robot, uint32_t count, const float* floats,
                      flashbvh_joint_coordinate* values) {
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t first = i * robot->variable_count;
    flashbvh_set_values(robot, floats + first, values + first);
  }
}

/// Checks one period per row of values. A refused row is not an error: its answer has the status.
EXPORT void check(flashbvh_guard* guard, const flashbvh_robot* robot, uint32_t count,
                  const flashbvh_joint_coordinate* values, uint32_t work, uint8_t* statuses,
                  uint8_t* verdicts, uint16_t* pairs, uint32_t* distances, uint32_t* works) {
  for (uint32_t i = 0; i < count; ++i) {
    const flashbvh_guard_answer answer =
        flashbvh_guard_update(guard, values + i * robot->variable_count, work);
    statuses[i] = static_cast<uint8_t>(answer.status);
    verdicts[i] = static_cast<uint8_t>(answer.verdict);
    pairs[i] = answer.pair;
    distances[i] = answer.distance;
    works[i] = answer.work;
  }
}

}  // namespace batches
