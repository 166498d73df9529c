// Charts: how far two links are apart at least, by where the one or two joints between them stand.
//
// What the joints can do is cut into cells, up to 32 along each; of each cell the tool worked out a
// distance that no place in it falls below (tools/robot/baked/distance_tables.hpp). A byte a cell,
// those of all pairs end to end; of a pair's two joints, the one nearer to its link A first, in
// rows.
#ifndef FLASHBVH_DETAIL_ROBOT_DISTANCE_TABLE_HPP
#define FLASHBVH_DETAIL_ROBOT_DISTANCE_TABLE_HPP

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// A joint's cells: how many, of 2^shift coordinates each, from `lower` on.
struct ChartAxis {
  JointCoordinate lower;
  uint32_t shift;
  uint32_t cells;
};
ChartAxis distance_table_axis(const RobotJoint& joint);

/// Cells of the pair's distance table; 0 if it has none: more joints are between, or a mimic, or
/// what a workcell added.
uint32_t distance_table_size(const Robot& robot, const RobotPair& pair);

/// A byte's distance, in 1/256 cell: four bits after a leading one, and an exponent; 0: not known.
constexpr uint32_t table_distance(uint8_t byte) {
  return byte == 0 ? 0 : (16u + (byte & 15u)) << (byte >> 4) << 8;
}

/// What the pair's distance table says of where the joints stand; 0 if there is none.
uint32_t chart_distance_at(const Robot& robot, uint16_t pair, const JointCoordinate* coordinates);

}  // namespace flashbvh::detail

#endif
