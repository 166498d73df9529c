// Exits with 0 if the peg touches nothing above the plate and touches it below.
#include <flashbvh/flashbvh.hpp>

#include "peg.fbvh.h"
#include "plate.fbvh.h"

const auto plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
const auto peg = flashbvh::view_unchecked<flashbvh::Mesh>(peg_image);

static bool touches(double height) {
  const auto cells = static_cast<int32_t>(height / plate_CELL);
  return intersects(plate, peg, flashbvh::Pose::translated(0, 0, cells)).yes;
}

int main() {
  return !touches(0.5) && touches(-2) ? 0 : 1;
}
