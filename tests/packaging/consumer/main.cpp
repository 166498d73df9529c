// Exits with 0 if the peg touches nothing above the plate and touches it below.
#include <flashbvh/flashbvh.hpp>
#include <flashbvh/image.hpp>

#include "peg.fbvh.h"
#include "plate.fbvh.h"

namespace {

const auto plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
const auto peg = flashbvh::view_unchecked<flashbvh::Mesh>(peg_image);

bool touches(double height) {
  const auto cells = static_cast<int32_t>(height / plate_CELL);
  const auto pose = flashbvh::Pose::translated(0, 0, cells);
  flashbvh::PairQuery query(plate, peg, pose);
  flashbvh::PairQuery::Pair found[8];
  return query.run(0xFFFF, found).count != 0;
}

}  // namespace

int main() {
  return !touches(0.5) && touches(-2) ? 0 : 1;
}
