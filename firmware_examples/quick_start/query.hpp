// The query, in slices: does a peg touch a plate, or is it inside the plate?
#pragma once

#include <flashbvh/flashbvh.hpp>

#include "peg.fbvh.h"
#include "plate.fbvh.h"

const auto plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
const auto peg = flashbvh::view_unchecked<flashbvh::Mesh>(peg_image);

/// Converts millimetres, the unit of both meshes, to cells.
constexpr int32_t cells(double millimetres) {
  return static_cast<int32_t>(millimetres / plate_CELL + (millimetres < 0 ? -0.5 : 0.5));
}

/// Work of a slice that takes at most 50,000 instructions on a Cortex-M4F, proven for any pose. For
/// other cores see time_bound.hpp.
constexpr uint32_t kWork =
    flashbvh::work_within(50000, flashbvh::kCortexM4F, plate_TREE_SIZE, peg_TREE_SIZE);

/// True if the peg, `height` cells above the plate's origin, touches the plate or is inside it.
inline bool touches(int32_t height) {
  const flashbvh::Pose pose = flashbvh::Pose::translated(0, 0, height);
  flashbvh::PairQuery query(plate, peg, pose);  // a few words on the stack
  flashbvh::PairQuery::Pair found[8];
  for (;;) {
    const flashbvh::RunResult step = query.run(kWork, found);  // returns after kWork at most
    if (step.count != 0) {
      return true;  // found[0].a and found[0].b are triangles of plate.obj and peg.obj
    }
    if (step.status != flashbvh::Status::suspended) {
      // Free: no triangles intersect, and the peg is not wholly inside the plate. An error is no
      // permission to move on.
      return step.status != flashbvh::Status::done || one_is_inside(plate, peg, pose).yes;
    }
    // Not finished: do other work here, then continue.
  }
}
