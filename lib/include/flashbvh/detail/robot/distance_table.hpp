// Reads a pair's distance table.
#pragma once

#include <stdint.h>

#include "flashbvh/robot/distance_table.hpp"

namespace flashbvh::detail {

/// The distance in the pair's table at these joint coordinates; 0 if there is no table.
uint32_t table_distance_at(const Robot& robot, uint16_t pair, const JointCoordinate* coordinates);

}  // namespace flashbvh::detail
