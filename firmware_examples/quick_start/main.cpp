// A query in slices: a peg above a plate, lowered until they touch, and wholly inside it.
#include "peg.fbvh.h"
#include "plate.fbvh.h"
#include "text.hpp"

#include <flashbvh/flashbvh.hpp>
#include <flashbvh/image.hpp>

static_assert(peg_IMAGE_BYTES + plate_IMAGE_BYTES < 2 * 1024);

namespace {

const auto plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
const auto peg = flashbvh::view_unchecked<flashbvh::Mesh>(peg_image);

/// Millimetres, the unit of the two meshes, to cells.
constexpr int32_t cells(double millimetres) {
  return static_cast<int32_t>(millimetres / plate_CELL + (millimetres < 0 ? -0.5 : 0.5));
}

/// What a slice may do in 50,000 instructions on a Cortex-M4F: proven, for any pose.
constexpr uint32_t kWork =
    flashbvh::work_within(50000, flashbvh::kCortexM4F, plate_TREE_SIZE, peg_TREE_SIZE);

/// Whether the peg, `height` cells above the plate's origin, touches the plate or is inside it.
bool touches(int32_t height) {
  const flashbvh::Pose pose = flashbvh::Pose::translated(0, 0, height);
  flashbvh::PairQuery query(plate, peg, pose);  // a few words on the stack
  flashbvh::PairQuery::Pair found[8];
  for (;;) {
    const flashbvh::RunResult step = query.run(kWork, found);  // then it comes back
    if (step.count != 0) {
      return true;  // found[0].a and found[0].b are triangles of plate.obj and peg.obj
    }
    if (step.status != flashbvh::Status::suspended) {
      // Free: no triangles intersect, nor is the peg wholly inside the plate. An error is no
      // permission to move on.
      return step.status != flashbvh::Status::done || one_is_inside(plate, peg, pose).yes;
    }
    // Not finished: do something else, and come back.
  }
}

}  // namespace

int main() {
  const bool above = touches(cells(0.5));
  const bool on = touches(cells(0));
  const bool in = touches(cells(-2));
  const bool inside = touches(cells(-35));  // 5 mm of the plate above it and below
  port::print("0.5 mm above the plate: ", above ? "touches" : "free", "\n");
  port::print("on the plate: ", on ? "touches" : "free", "\n");
  port::print("2 mm into the plate: ", in ? "touches" : "free", "\n");
  port::print("wholly inside the plate: ", inside ? "touches" : "free", "\n");
  return !above && on && in && inside ? 0 : 1;
}
