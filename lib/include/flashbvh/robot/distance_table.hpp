// Distance tables: lower bounds of the distance between two links, over the values of the one or
// two joints between them. For programs that write or show them; guards look them up by themselves.
//
// A table cuts each joint's range into up to 32 cells and holds a byte for each cell, or pair of
// cells; no pose in a cell brings the links nearer. Rows belong to the joint that is nearer to
// link A. Robot::distance_tables holds the tables of all pairs end to end.
#ifndef FLASHBVH_ROBOT_DISTANCE_TABLE_HPP
#define FLASHBVH_ROBOT_DISTANCE_TABLE_HPP

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh {

/// The cells of a joint: `cells` of 2^shift coordinates each, from `lower` on.
struct DistanceTableAxis {
  JointCoordinate lower;
  uint32_t shift;
  uint32_t cells;
};
/// The cells of a joint of the robot.
DistanceTableAxis distance_table_axis(const RobotJoint& joint);

/// Cells of the pair's distance table. 0 if the pair has no table: no joint or more than two joints
/// lie between its links, or one of them is fixed or a mimic.
uint32_t distance_table_size(const Robot& robot, const RobotPair& pair);

/// The distance that a byte of a table stands for, in 1/256 cell: four bits after a leading one,
/// and an exponent. 0: no bound.
constexpr uint32_t table_distance(uint8_t byte) {
  return byte == 0 ? 0 : (16u + (byte & 15u)) << (byte >> 4) << 8;
}

}  // namespace flashbvh

#endif
