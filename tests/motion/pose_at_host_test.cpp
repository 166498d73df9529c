// Poses along a motion, against Rodrigues' formula in doubles.
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

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

TEST_CASE("motions: a pose is within 2^-6 cell of the exact path, and as given at its ends") {
  for_rounds(rounds(4'000, 100'000), [&](Random& random, int) {
    const Encounter of(random);
    const BodyMotion& motion = of.motion;
    if (motion.status() != Status::done) {
      return;
    }
    REQUIRE(are_same(motion.pose_at(0), of.any.from));
    REQUIRE(are_same(motion.pose_at(kMotionEnd), motion.to()));
    const ExactMotion exact(motion);
    const auto error = [&](double time, const Pose& pose, const FloatVector& p) {
      return length_of(minus(placed(pose, p), exact.at(time, p)));
    };
    for (int i = 0; i < 8; ++i) {
      const std::uint32_t time = 1 + random.below(kMotionEnd - 1);
      CAPTURE(time);
      const Pose pose = motion.pose_at(time);
      REQUIRE(pose.status() == Status::done);
      const double most = random.below(2) * kMaxCoordinate;
      REQUIRE(error(time / 1073741824.0, pose, {most, -most, most}) < 1.0 / 64);
    }
    if (of.any.moves.empty()) {  // between two poses: straight, and the shorter way
      REQUIRE(are_same(motion.to(), of.any.to));
      REQUIRE(motion.move_count() == 1);
      REQUIRE(std::abs(motion.move(0).turn) <= kFullTurn / 2 + 1);
      const FloatVector begin = placed(motion.from(), {0, 0, 0});
      const FloatVector way = minus(placed(motion.to(), {0, 0, 0}), begin);
      for (const double time : {0.25, 0.5, 1.0}) {
        REQUIRE(length_of(minus(exact.at(time, FloatVector{0, 0, 0}), plus(begin, time, way))) <
                1e-3);
      }
      REQUIRE(error(1, motion.to(), {1000, 1000, 1000}) < 0.2);  // five decimals: 2^-13
    }
  });
}
