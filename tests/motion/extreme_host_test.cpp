// Motions of any numbers are refused or end: at the limits of each range.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

/// A number that is small, near a power of two, or random.
int32_t extreme(Random& random) {
  const auto power = static_cast<int32_t>(1u << random.below(31));
  const int32_t near = power - 1 + random.between(-1, 1);
  switch (random.below(4)) {
    case 0:
      return random.between(-3, 3);
    case 1:
      return near;
    case 2:
      return -near;
    default:
      return static_cast<int32_t>(random.next());
  }
}

/// A coordinate of a mesh or a pose, mostly in range.
int32_t any_cells(Random& random) {
  return random.below(3) != 0 ? random.between(-300, 300) : extreme(random) >> random.below(14);
}

Move extreme_move(Random& random, const MotionScene& scene) {
  Move move = any_move(random, scene.size, scene.size);
  int32_t* const numbers[] = {&move.point[0],  &move.point[1], &move.point[2], &move.axis[0],
                              &move.axis[1],   &move.axis[2],  &move.turn,     &move.travel[0],
                              &move.travel[1], &move.travel[2]};
  for (uint32_t i = random.below(4); i-- > 0;) {
    *numbers[random.below(10)] = extreme(random);
  }
  return move;
}

Pose extreme_pose(Random& random) {
  int32_t cells[3];
  int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = any_cells(random);
    fraction[i] = static_cast<int16_t>(random.next());
  }
  return Pose::rigid(rotation_of(any_quaternion(random)).entry, cells, fraction);
}

}  // namespace

TEST_CASE("motions: any numbers are refused or lead to an end") {
  long ended = 0;
  long refused = 0;
  for_rounds(rounds(3'000L, 100'000L), [&](Random& random, long) {
    MotionScene scene = MotionScene::any(random);
    Mesh a = scene.a.baked.view();
    Mesh b = scene.b.baked.view();
    for (Mesh* const mesh : {&a, &b}) {
      for (int32_t& axis : mesh->origin) {
        axis = std::clamp(any_cells(random), -(1 << 29), 1 << 29);
      }
    }
    AnyMotion any;
    any.from = extreme_pose(random);
    any.to = extreme_pose(random);
    any.moves.resize(random.below(random.below(20) == 0 ? 70 : 4));
    for (Move& move : any.moves) {
      move = extreme_move(random, scene);
    }
    const BodyMotion motion = any.motion();
    (void)motion.pose_at(random.below(kMotionEnd));
    const auto within = static_cast<std::uint32_t>(extreme(random));
    FirstContact query(a, b, motion,
                       {random.below(2) == 0 ? 0 : within % (kMaxMotionDistance + 2)});
    if (query.status() != Status::suspended) {
      ++refused;
      return;
    }
    const FirstContactAnswer answer = query.run(100'000'000);
    CAPTURE(answer.from, answer.to);
    REQUIRE(answer.status != Status::suspended);
    ended += answer.status == Status::done ? 1 : 0;
  });
  CHECK(ended > 300);
  CHECK(refused > 300);
}
