// What a pair's distance table says.
#ifndef FLASHBVH_DETAIL_ROBOT_DISTANCE_TABLE_HPP
#define FLASHBVH_DETAIL_ROBOT_DISTANCE_TABLE_HPP

#include <stdint.h>

#include "flashbvh/robot/distance_table.hpp"

namespace flashbvh::detail {

/// What the pair's distance table says of where the joints stand; 0 if there is none.
uint32_t table_distance_at(const Robot& robot, uint16_t pair, const JointCoordinate* coordinates);

}  // namespace flashbvh::detail

#endif
