// First contacts of turning bodies, against bodies placed in doubles. The oracle steps by their
// distance, which prevents contact before the next step; by 0.1 cells if they are nearer, which
// misses at most a contact of 0.05 cells. A few motions take too many steps; the rest of theirs is
// sampled.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

constexpr double kEnd = kMotionEnd;

class Checked {
 public:
  Checked(const MotionScene& scene, const BodyMotion& motion, std::uint32_t within)
      : a_(scene.a.baked.view()),
        b_(scene.b.baked.view()),
        float_a_(float_mesh(a_)),
        float_b_(float_mesh(b_)),
        motion_(motion),
        exact_(motion),
        within_(within) {}

  bool is_too_far() const {
    return FirstContact(a_, b_, motion_).status() == Status::motion_out_of_range;
  }

  ContactOutcome check() {
    FirstContact query(a_, b_, motion_, {within_});
    const FirstContactAnswer answer = query.run(UINT32_MAX);
    CAPTURE(answer.from, answer.to, within_, static_cast<int>(answer.outcome));
    REQUIRE(answer.status == Status::done);
    REQUIRE((answer.from <= answer.to && answer.to <= kMotionEnd));
    if (answer.outcome == ContactOutcome::free) {
      check_apart(kMotionEnd);
      REQUIRE_FALSE(touch_at(0));
      REQUIRE_FALSE(touch_at(kMotionEnd));
      return answer.outcome;
    }
    check_apart(answer.from);
    REQUIRE(moved_most(answer.from, answer.to) <= 1);
    if (answer.outcome == ContactOutcome::contact) {
      REQUIRE(touch_at(answer.to));
    } else {
      REQUIRE(least_distance(answer.from, answer.to) <= (query.close_distance() - within_) / 256.0);
    }
    return answer.outcome;
  }

  /// Whether the oracle took too many steps.
  bool is_sampled() const { return is_sampled_; }

 private:
  /// The distance of the exact bodies, less the distance that they must keep.
  double distance_at(double time) const {
    return distance_of(float_a_, exact_.at(time, float_b_)) - within_ / 256.0;
  }

  void check_apart(std::uint32_t until) {
    constexpr int kMostSteps = 2000;
    const double speed = exact_.speed(float_b_);
    const double end = until / kEnd;
    int steps = 0;
    for (double time = 0; time < end; ++steps) {
      const double apart = distance_at(time);
      REQUIRE(apart > 0);
      check_rounded(time, apart);
      const double sampled = steps < kMostSteps ? 0 : speed * end / 500;
      time += std::max({apart, 0.1, sampled}) / speed;
    }
    is_sampled_ = steps > kMostSteps;
    REQUIRE((until == 0 || distance_at(end) > 0));
  }

  /// Checks that bodies 0.9 cells apart do not touch when the pose rounds them.
  void check_rounded(double time, double apart) const {
    if (apart > 0.9 && apart < 3) {
      REQUIRE_FALSE(touch_at(static_cast<std::uint32_t>(time * kEnd)));
    }
  }

  bool touch_at(std::uint32_t time) const {
    const Pose pose = motion_.pose_at(time);
    return within_ == 0 ? intersects(a_, b_, pose).yes : closer_than(a_, b_, pose, {within_}).yes;
  }

  double least_distance(std::uint32_t from, std::uint32_t to) const {
    double least = 1e9;
    for (int i = 0; i <= 8; ++i) {
      least = std::min(least, distance_at((from + i * ((to - from) / 8.0)) / kEnd));
    }
    return least;
  }

  /// The largest length_of(corner) of B's corners.
  template <class LengthOf>
  double most_of_corners(const LengthOf& length_of) const {
    double most = 0;
    for (const FloatTriangle& t : float_b_) {
      most = std::max({most, length_of(t[0]), length_of(t[1]), length_of(t[2])});
    }
    return most;
  }

  /// A lower bound of the travel of the corner that moves most.
  double moved_most(std::uint32_t from, std::uint32_t to) const {
    return most_of_corners([&](const FloatVector& p) {
      const auto at = [&](int k) { return exact_.at((from + k * ((to - from) / 4.0)) / kEnd, p); };
      double moved = 0;
      for (int i = 0; i < 4; ++i) {
        moved += std::sqrt(squared(minus(at(i + 1), at(i))));
      }
      return moved;
    });
  }

  /// The distance between the end of the moves and the motion's end pose.
  double off_at_end() const {
    return most_of_corners([&](const FloatVector& p) {
      return std::sqrt(squared(minus(placed(motion_.to(), p), exact_.at(1, p))));
    });
  }

  Mesh a_;
  Mesh b_;
  FloatMesh float_a_;
  FloatMesh float_b_;
  const BodyMotion& motion_;
  ExactMotion exact_;
  std::uint32_t within_;
  bool is_sampled_ = false;
};

}  // namespace

TEST_CASE("turns and chains of moves: no contact is reported late, none is missed") {
  long outcomes[3] = {};
  long sampled = 0;
  const long scenes = rounds(250L, 20'000L);
  for_rounds(scenes, [&](Random& random, long) {
    const MotionScene scene = MotionScene::any(random);
    for (int i = 0; i < 6; ++i) {
      CAPTURE(i);
      const AnyMotion any = any_motion(random, scene);
      const BodyMotion motion = any.motion();
      const std::uint32_t withins[] = {0, 0, 1, 256, 3000, 10'000};
      Checked checked(scene, motion, withins[random.below(6)]);
      if (!checked.is_too_far()) {
        ++outcomes[static_cast<int>(checked.check())];
        sampled += checked.is_sampled() ? 1 : 0;
      }
    }
  });
  for (const long count : outcomes) {
    CHECK(count > scenes / 10);
  }
  CHECK(sampled < scenes / 4);  // of six motions a scene
}
