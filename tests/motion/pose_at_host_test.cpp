// Poses along a motion, against Rodrigues' formula in doubles; and refused motions.
#include "flashbvh/first_contact.hpp"
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

double apart(const FloatVector& p, const FloatVector& q) {
  return std::sqrt(squared(minus(p, q)));
}

bool are_same(const Pose& p, const Pose& q) {
  bool same = true;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      same = same && p.rotation(i, j) == q.rotation(i, j);
    }
    same = same && p.translation(i) == q.translation(i) && p.fraction(i) == q.fraction(i);
  }
  return same;
}

}  // namespace

TEST_CASE("motions: a pose is within 2^-6 cell of the exact way, and as given at its ends") {
  for_rounds(rounds(2'000, 100'000), [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const AnyMotion any = any_motion(random, scene);
    const BodyMotion motion = any.motion();
    if (motion.status() != Status::done) {
      return;
    }
    REQUIRE(are_same(motion.pose_at(0), any.from));
    REQUIRE(are_same(motion.pose_at(kMotionEnd), motion.to()));
    REQUIRE((!any.moves.empty() || are_same(motion.to(), any.to)));
    const ExactMotion exact(motion);
    for (int i = 0; i < 8; ++i) {
      const std::uint32_t time = 1 + random.below(kMotionEnd - 1);
      CAPTURE(time);
      const Pose pose = motion.pose_at(time);
      REQUIRE(pose.status() == Status::done);
      const double most = random.below(2) * kMaxCoordinate;
      const FloatVector corner = {most, -most, most};
      REQUIRE(apart(placed(pose, corner), exact.at(time / 1073741824.0, corner)) < 1.0 / 64);
    }
  });
}

TEST_CASE("motions between poses: straight, and the shorter way round to the end") {
  for_rounds(rounds(2'000, 100'000), 1, [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const Pose from = any_end(random, scene);
    const Pose to = any_end(random, scene);
    const BodyMotion motion = BodyMotion::between(from, to);
    REQUIRE(motion.status() == Status::done);
    REQUIRE(motion.move_count() == 1);
    REQUIRE(std::abs(motion.move(0).turn) <= kFullTurn / 2 + 1);
    const ExactMotion exact(motion);
    const FloatVector begin = placed(from, {0, 0, 0});
    const FloatVector way = minus(placed(to, {0, 0, 0}), begin);
    for (const double time : {0.25, 0.5, 1.0}) {
      REQUIRE(apart(exact.at(time, FloatVector{0, 0, 0}), plus(begin, time, way)) < 1e-3);
    }
    const FloatVector corner = {1000, 1000, 1000};
    REQUIRE(apart(exact.at(1, corner), placed(to, corner)) < 0.2);  // five decimals: 2^-13
  });
}
