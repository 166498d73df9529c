#include "flashbvh/detail/robot/distance_table.hpp"

#include "branch.hpp"
#include "coordinate.hpp"

namespace flashbvh {
namespace {

constexpr int kAxisCellBits = 5;

}  // namespace

/// Not inlined: the call bounds its loop (proofs/time).
FLASHBVH_NOINLINE DistanceTableAxis distance_table_axis(const RobotJoint& joint) {
  const bool is_free = joint.type == JointType::continuous;
  const bool is_empty = joint.lower > joint.upper;
  const uint32_t range = is_free    ? kFullTurn - 1
                         : is_empty ? 0
                                    : detail::apart(joint.lower, joint.upper);
  // Smallest shift that leaves kAxisCellBits, by bisection: clz would link libgcc's function.
  uint32_t shift = 0;
  for (uint32_t step = 16; step != 0; step /= 2) {
    shift += range >> (shift + step - 1) >> kAxisCellBits != 0 ? step : 0;
  }
  return {is_free ? -kFullTurn / 2 : joint.lower, shift, (range >> shift) + 1};
}

uint32_t distance_table_size(const Robot& robot, const RobotPair& pair) {
  const uint32_t between = pair.joints_a + pair.joints_b;
  if (between == 0 || between > 2) {
    return 0;
  }
  uint32_t size = 1;
  detail::for_each_between(robot, pair, [&](uint32_t number, uint32_t) {
    const RobotJoint& joint = robot.joints[number];
    const bool is_own = joint.shift == 0 && joint.type != JointType::fixed;
    size *= is_own ? distance_table_axis(joint).cells : 0;
  });
  return size;
}

namespace detail {

uint32_t table_distance_at(const Robot& robot, uint16_t i, const JointCoordinate* coordinates) {
  const RobotPair& pair = robot.pairs[i];
  const uint32_t size = distance_table_size(robot, pair);
  if (size == 0) {
    return 0;
  }
  uint32_t place = 0;
  for (uint16_t before = 0; before < i; ++before) {
    place += distance_table_size(robot, robot.pairs[before]);
  }
  if (place + size > robot.distance_table_bytes) {
    return 0;
  }
  uint32_t cell = 0;
  for_each_between(robot, pair, [&](uint32_t number, uint32_t) {
    const RobotJoint& joint = robot.joints[number];
    const DistanceTableAxis axis = distance_table_axis(joint);
    const bool is_free = joint.type == JointType::continuous;
    const JointCoordinate at = is_free ? wrapped(coordinates[number]) : coordinates[number];
    const uint32_t along = apart(axis.lower, at) >> axis.shift;
    cell = cell * axis.cells + (at < axis.lower || along >= axis.cells ? size : along);
  });
  return cell < size ? table_distance(robot.distance_tables[place + cell]) : 0;
}

}  // namespace detail
}  // namespace flashbvh
