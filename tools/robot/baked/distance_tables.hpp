// Distance tables of the pairs that have one or two joints between their links: what a guard knows
// of them without testing a mesh (lib/src/robot/distance_table.hpp has the layout).
//
// A cell's distance is proven as the matrix proves: at the middle of a part of it, the links are as
// far apart as the exact query says; nothing in the part is nearer by more than the joints move the
// links in it. Parts are halved until that is most of the least distance seen in the cell.
#ifndef FLASHBVH_TOOLS_ROBOT_BAKED_DISTANCE_TABLES_HPP
#define FLASHBVH_TOOLS_ROBOT_BAKED_DISTANCE_TABLES_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/baked/fixed_robot.hpp"

namespace flashbvh::tool {

/// `robot`: of the model. `begin` is called with the number of each pair before its distance table.
std::vector<std::uint8_t> distance_tables_of(const Model& model, const Robot& robot,
                                             const std::function<void(std::size_t)>& begin);

}  // namespace flashbvh::tool

#endif
