// Distance tables: lower bounds of the distance between two links, by the values of the one or two
// joints between them. For programs that write or show tables; guards use them automatically.
//
// A table cuts each joint's range into up to 32 joint boxes. It holds a byte for each box, or pair
// of boxes: no pose in it brings the links nearer. Rows belong to the joint nearer to link A.
// Robot::distance_tables holds the tables of all pairs in sequence.
#pragma once

#include <stdint.h>

#include "flashbvh/robot/robot.hpp"

namespace flashbvh {

/// The joint boxes of one joint: `cells` boxes of 2^shift coordinates each, starting at `lower`.
struct DistanceTableAxis {
  JointCoordinate lower;
  uint32_t shift;
  uint32_t cells;
};
/// Returns the boxes of a robot's joint.
DistanceTableAxis distance_table_axis(const RobotJoint& joint);

/// Returns the number of bytes of the pair's table. 0 if the pair has none: no joint or more than
/// two joints lie between its links, or one of these is fixed or a mimic.
uint32_t distance_table_size(const Robot& robot, const RobotPair& pair);

/// Decodes a byte of a table to a distance in 1/256 cell: four bits after a leading one, and an
/// exponent. 0: no bound.
constexpr uint32_t table_distance(uint8_t byte) {
  return byte == 0 ? 0 : (16u + (byte & 15u)) << (byte >> 4) << 8;
}

}  // namespace flashbvh
