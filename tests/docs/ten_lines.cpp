// The C++ of README.md, which snippets.py writes.
#include "readme.cpp"

/// The peg upright, `height` mm above the plate.
static flashbvh::Pose lowered_to(float height) {
  return flashbvh::pose_of({1, 0, 0, 0}, {0, 0, height}, plate_CELLS_PER_UNIT);
}

int main() {
  const flashbvh::Pose above = lowered_to(3);
  return may_go(lowered_to(0.5f)) && !may_go(lowered_to(0)) && is_near(above, 3.1f) &&
                 !is_near(above, 2.9f) && is_near(above, -1)
             ? 0
             : 1;
}
