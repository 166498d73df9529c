// First contacts of translated bodies, against exact linear programs for all pairs of triangles.
// FLASHBVH_MOTIONS sets the number of motions, and prints the results.
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "support/motion_scene.hpp"
#include "support/oracles/exact_motion.hpp"
#include "support/oracles/first_touch.hpp"
#include "support/print.hpp"
#include "support/test.hpp"
#include "support/transformed_mesh.hpp"

namespace {

constexpr long kOfAScene = 20;
constexpr double kEnd = kMotionEnd;

long motions() {
  return number_in("FLASHBVH_MOTIONS", rounds(100'000L, 1'000'000L));
}

struct Found {
  long of[3] = {};     ///< by outcome
  long late = 0;       ///< contacts before the reported time
  long missed = 0;     ///< contacts in motions reported free
  double longest = 0;  ///< the longest interval, in cells
};

class Checked {
 public:
  Checked(const MotionScene& scene, const Translation& way)
      : scene_(scene), way_(way), motion_(way.motion()) {}

  void check(Found& found) const {
    const Mesh a = scene_.a.baked.view();
    const Mesh b = scene_.b.baked.view();
    FirstContact query(a, b, motion_);
    if (query.status() == Status::motion_out_of_range) {
      return;
    }
    const FirstContactAnswer answer = query.run(UINT32_MAX);
    CAPTURE(way_.from.x, way_.from.y, way_.from.z, way_.way.x, way_.way.y, way_.way.z, answer.from,
            answer.to);
    REQUIRE(answer.status == Status::done);
    ++found.of[static_cast<int>(answer.outcome)];
    const bool is_free = answer.outcome == ContactOutcome::free;
    REQUIRE((answer.from <= answer.to && answer.to <= kMotionEnd));
    const bool is_early = !touches_before(is_free ? kMotionEnd : answer.from, is_free);
    CHECK(is_early);
    (is_free ? found.missed : found.late) += is_early ? 0 : 1;
    if (is_free) {
      REQUIRE_FALSE(intersects(a, b, motion_.from()).yes);
      REQUIRE_FALSE(intersects(a, b, motion_.to()).yes);
      return;
    }
    const FloatVector way = {double(way_.way.x), double(way_.way.y), double(way_.way.z)};
    const double moved = (answer.to - answer.from) / kEnd * std::sqrt(squared(way));
    found.longest = std::max(found.longest, moved);
    REQUIRE(moved <= 1);
    answer.outcome == ContactOutcome::contact ? check_contact(answer) : check_close(answer);
  }

 private:
  /// Whether the bodies touch before a time, or at it.
  bool touches_before(std::uint32_t time, bool or_at) const {
    const Pose here = Pose::translated(0, 0, 0);
    for (std::uint32_t j = 0; j < scene_.b.source.triangles.size(); ++j) {
      const Triangle b = shifted(transformed(scene_.b.source, j, here), way_.from);
      for (std::uint32_t i = 0; i < scene_.a.source.triangles.size(); ++i) {
        const Triangle a = transformed(scene_.a.source, i, here);
        if (!boxes_meet(a, b, way_.way, time / kEnd)) {
          continue;
        }
        const FirstTouch touch = first_touch(a, b, way_.way);
        REQUIRE(is_proven(touch, a, b, way_.way));
        const Wide order = touch.time * kMotionEnd - touch.scale * time;
        if (touch.touches && (order < 0 || (or_at && order == 0))) {
          return true;
        }
      }
    }
    return false;
  }

  void check_contact(const FirstContactAnswer& answer) const {
    const Pose pose = motion_.pose_at(answer.to);
    REQUIRE(detail::triangles_intersect(
        transformed(scene_.a.source, answer.triangles.a, Pose::translated(0, 0, 0)),
        transformed(scene_.b.source, answer.triangles.b, pose)));
  }

  void check_close(const FirstContactAnswer& answer) const {
    const ExactMotion exact(motion_);
    const FloatMesh a = float_mesh(scene_.a.baked.view());
    const FloatMesh b = float_mesh(scene_.b.baked.view());
    double least = 1e9;
    for (int i = 0; i <= 4; ++i) {
      const double time = (answer.from + i * ((answer.to - answer.from) / 4.0)) / kEnd;
      least = std::min(least, distance_of(a, exact.at(time, b), 1));
    }
    REQUIRE(least <= 1);
  }

  const MotionScene& scene_;
  const Translation& way_;
  BodyMotion motion_;
};

}  // namespace

TEST_CASE("translations: no contact is reported late, none is missed") {
  Found found;
  for_rounds(motions() / kOfAScene, [&](Random& random, long) {
    const MotionScene scene = MotionScene::any(random);
    for (long i = 0; i < kOfAScene; ++i) {
      const Translation way = any_translation(random, scene);
      Checked(scene, way).check(found);
    }
  });
  for (const long count : found.of) {
    CHECK(count > motions() / 100);
  }
  if (setting("FLASHBVH_MOTIONS") != nullptr) {
    print("late ", found.late, ", missed ", found.missed, "; free ", found.of[0], ", contact ",
          found.of[1], ", close ", found.of[2], "; longest interval ", found.longest, " cells\n");
  }
}
