#include "mesh/placement.hpp"

#include <algorithm>
#include <cmath>

#include "text/messages.hpp"

namespace flashbvh::tool {

void PlacedPoints::add(const Position& at, const Placement& placement) {
  Position point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& row = placement[axis];
    double size = 0;
    for (const double part : {row[0] * at[0], row[1] * at[1], row[2] * at[2], row[3]}) {
      point[axis] += part;
      size += std::fabs(part);
    }
    if (!is_coordinate(size)) {
      throw UserError(file_,
                      "has a coordinate that is no finite number of at most 3.4e38; repair "
                      "the mesh");
    }
    largest_ = std::max(largest_, size);
  }
  builder_.add_point(point);
}

}  // namespace flashbvh::tool
