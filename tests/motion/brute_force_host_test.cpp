// First contacts against brute force over all pairs of triangles. Translations: exact linear
// programs. Other motions: bodies placed in doubles, at steps of their distance, which prevents
// contact before the next step; of 0.1 cells if they are nearer, which misses at most a contact of
// 0.05 cells. A few motions take too many steps; the rest of theirs is sampled.
#include "flashbvh/clearance.hpp"
#include "flashbvh/shape.hpp"
#include "support/any_motion.hpp"
#include "support/oracles/first_touch.hpp"
#include "support/queries.hpp"
#include "support/test.hpp"

namespace {

constexpr double kEnd = kMotionEnd;

/// Two bodies on a motion, and its first contact.
class Checked {
 public:
  Checked(const Mesh& a, const Mesh& b, const BodyMotion& motion, std::uint32_t within)
      : a_(a),
        b_(b),
        float_a_(float_mesh(a)),
        float_b_(float_mesh(b)),
        motion_(motion),
        exact_(motion),
        within_(within) {}

  bool is_in_range() const { return FirstContact(a_, b_, motion_).status() == Status::suspended; }

  /// Checks an answer but for the time before it: calls check_apart(time) for that. Returns the
  /// outcome.
  template <class CheckApart>
  ContactOutcome check(const CheckApart& check_apart) const {
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
      REQUIRE(triangles_touch(answer));
    } else {
      REQUIRE(least_distance(answer.from, answer.to) <= query.close_distance() / 256.0);
    }
    return answer.outcome;
  }

  /// Checks that the bodies stay apart until a time. Returns whether most of it was sampled.
  bool check_apart(std::uint32_t until) const {
    constexpr int kMostSteps = 2000;
    const double speed = exact_.speed(float_b_);
    const double end = until / kEnd;
    int steps = 0;
    for (double time = 0; time < end; ++steps) {
      const double apart = distance_at(time) - within_ / 256.0;
      REQUIRE(apart > 0);
      if (apart > 0.9 && apart < 3) {  // so they do not touch when the pose rounds them
        REQUIRE_FALSE(touch_at(static_cast<std::uint32_t>(time * kEnd)));
      }
      const double sampled = steps < kMostSteps ? 0 : speed * end / 500;
      time += std::max({apart, 0.1, sampled}) / speed;
    }
    REQUIRE((until == 0 || distance_at(end) > within_ / 256.0));
    return steps > kMostSteps;
  }

 private:
  double distance_at(double time) const { return distance_of(float_a_, exact_.at(time, float_b_)); }

  bool touch_at(std::uint32_t time) const {
    const Pose pose = motion_.pose_at(time);
    return within_ == 0 ? intersects(a_, b_, pose).yes : closer_than(a_, b_, pose, {within_}).yes;
  }

  /// Whether the reported triangles touch; true if bodies are to keep a distance.
  bool triangles_touch(const FirstContactAnswer& answer) const {
    Triangle a;
    Triangle b;
    return transform_pair(a_, b_, motion_.pose_at(answer.to), answer.triangles, a, b) &&
           (within_ != 0 || detail::triangles_intersect(a, b));
  }

  double least_distance(std::uint32_t from, std::uint32_t to) const {
    double least = 1e9;
    for (int i = 0; i <= 8; ++i) {
      least = std::min(least, distance_at((from + i * ((to - from) / 8.0)) / kEnd));
    }
    return least;
  }

  /// A lower bound of the travel of B's corner that moves most.
  double moved_most(std::uint32_t from, std::uint32_t to) const {
    double most = 0;
    for (const FloatTriangle& t : float_b_) {
      for (const FloatVector& p : t) {
        const auto at = [&](int k) {
          return exact_.at((from + k * ((to - from) / 4.0)) / kEnd, p);
        };
        double moved = 0;
        for (int i = 0; i < 4; ++i) {
          moved += length_of(minus(at(i + 1), at(i)));
        }
        most = std::max(most, moved);
      }
    }
    return most;
  }

  Mesh a_;
  Mesh b_;
  FloatMesh float_a_;
  FloatMesh float_b_;
  const BodyMotion& motion_;
  ExactMotion exact_;
  std::uint32_t within_;
};

/// Whether two bodies touch before a time, or at it.
bool touch_before(const MotionScene& scene, const Translation& way, std::uint32_t time,
                  bool or_at) {
  const Pose here = Pose::translated(0, 0, 0);
  for (std::uint32_t j = 0; j < scene.b.source.triangles.size(); ++j) {
    const Triangle b = shifted(transformed(scene.b.source, j, here), way.from);
    for (std::uint32_t i = 0; i < scene.a.source.triangles.size(); ++i) {
      const Triangle a = transformed(scene.a.source, i, here);
      if (!boxes_meet(a, b, way.way, time / kEnd)) {
        continue;
      }
      const FirstTouch touch = first_touch(a, b, way.way);
      REQUIRE(is_proven(touch, a, b, way.way));
      const Wide order = touch.time * kMotionEnd - touch.scale * time;
      if (touch.touches && (order < 0 || (or_at && order == 0))) {
        return true;
      }
    }
  }
  return false;
}

void check_seen(const long (&outcomes)[3], long least) {
  for (const long count : outcomes) {
    CHECK(count > least);
  }
}

}  // namespace

TEST_CASE("translations: no contact is reported late, none is missed") {
  long outcomes[3] = {};
  const long scenes = rounds(2'500L, 50'000L);
  for_rounds(scenes, [&](Random& random, long) {
    const MotionScene scene = MotionScene::any(random);
    for (int i = 0; i < 20; ++i) {
      const Translation way = any_translation(random, scene);
      const BodyMotion motion = way.motion();
      const Checked checked(scene.a.baked.view(), scene.b.baked.view(), motion, 0);
      if (checked.is_in_range()) {
        CAPTURE(way.from.x, way.from.y, way.from.z, way.way.x, way.way.y, way.way.z);
        ++outcomes[static_cast<int>(checked.check([&](std::uint32_t until) {
          REQUIRE_FALSE(touch_before(scene, way, until, until == kMotionEnd));
        }))];
      }
    }
  });
  check_seen(outcomes, scenes / 5);
}

TEST_CASE("motions of bodies and shapes: no contact is reported late, none is missed") {
  long outcomes[3] = {};
  long sampled = 0;
  const long motions = rounds(1'500L, 120'000L);
  for_rounds(motions, [&](Random& random, long) {
    const Encounter of(random);
    const Point p = of.scene.b.any_corner(random);
    const Point q = of.scene.b.any_corner(random);
    const PointShape point(of.b, p);
    const SegmentShape segment(of.b, p, q);
    const Mesh* const bodies[] = {&of.b, &of.b, &point.mesh(), &segment.mesh()};
    const std::uint32_t withins[] = {0, 0, 1, 256, 3000, 10'000};
    const Mesh& b = *random.one_of(bodies);
    const Checked checked(of.a, b, of.motion, random.one_of(withins));
    if (checked.is_in_range()) {
      ++outcomes[static_cast<int>(checked.check(
          [&](std::uint32_t until) { sampled += checked.check_apart(until) ? 1 : 0; }))];
    }
  });
  check_seen(outcomes, motions / 60);
  CHECK(sampled < motions / 24);
}
