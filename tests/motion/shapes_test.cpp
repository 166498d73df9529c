// Sweeping shapes against closed forms: the time at which a ball, a capsule or a box meets a body.
#include "flashbvh/first_contact.hpp"
#include "flashbvh/shape.hpp"
#include "support/motion_scene.hpp"
#include "support/test.hpp"

namespace {

constexpr double kPi = 3.14159265358979323846;

/// A mesh with the cell of all shapes.
Mesh some_mesh() {
  static Random random(1);
  static const Body body(random, random_mesh(random, 1, 5, 5));
  return body.baked.view();
}

const Mesh& wall() {  // at x >= 0
  static const BoxShape box(some_mesh(), {0, -500, -500}, {50, 500, 500});
  return box.mesh();
}

/// `speed`: at contact, in cells per motion; `radius` in cells.
void check_meets(const Mesh& a, const Mesh& b, const BodyMotion& motion, std::uint32_t radius,
                 double time, double speed) {
  FirstContact query(a, b, motion, {radius * 256});
  const FirstContactAnswer answer = query.run(UINT32_MAX);
  const double from = answer.from / double{kMotionEnd};
  const double to = answer.to / double{kMotionEnd};
  CAPTURE(from, to, time, speed);
  REQUIRE(answer.status == Status::done);
  REQUIRE(answer.outcome != ContactOutcome::free);
  CHECK(from <= time);
  CHECK(from >= time - 2 / speed);
  CHECK(to <= time + 2 / speed);
}

void check_passes(const Mesh& a, const Mesh& b, const BodyMotion& motion, std::uint32_t radius) {
  FirstContact query(a, b, motion, {radius * 256});
  const FirstContactAnswer answer = query.run(UINT32_MAX);
  REQUIRE(answer.status == Status::done);
  CHECK(answer.outcome == ContactOutcome::free);
}

BodyMotion straight(const Point& from, const Point& way) {
  return Translation{from, way}.motion();
}

/// Turns about the z axis through `at`, with a pitch, in cells.
Move turning(double turns, const Point& at = {0, 0, 0}, int32_t pitch = 0) {
  return {{at.x * kFrameCell, at.y * kFrameCell, at.z * kFrameCell},
          {0, 0, kRotationOne},
          static_cast<int32_t>(turns * kFullTurn),
          {0, 0, pitch * kFrameCell}};
}

}  // namespace

TEST_CASE("a ball meets a wall that it flies to") {
  const PointShape point(some_mesh(), {0, 0, 0});
  for (const std::uint32_t radius : {0u, 1u, 7u, 100u}) {
    for (const Point& way : {Point{400, 0, 0}, Point{400, 300, 0}, Point{400, -200, 170}}) {
      const double time = (200.0 - radius) / way.x;
      check_meets(wall(), point.mesh(), straight({-200, 0, 0}, way), radius, time, way.x);
    }
    const auto beside = static_cast<int32_t>(radius) + 2;
    check_passes(wall(), point.mesh(), straight({-beside, -400, 0}, {0, 800, 0}), radius);
  }
}

TEST_CASE("a ball meets another where their middles are two radii apart") {
  const PointShape point(some_mesh(), {0, 0, 0});
  for (const int32_t beside : {0, 10, 59, 62}) {
    const BodyMotion motion = straight({-300, beside, 0}, {600, 0, 0});
    if (beside > 60) {
      check_passes(point.mesh(), point.mesh(), motion, 60);
      continue;
    }
    const double chord = std::sqrt(60.0 * 60 - beside * beside);
    check_meets(point.mesh(), point.mesh(), motion, 60, (300 - chord) / 600,
                600 * std::max(chord / 60, 0.1));
  }
}

TEST_CASE("a ball on an arm meets a wall that it turns to") {
  const PointShape point(some_mesh(), {0, 100, 0});  // the arm's axis is at x = -80
  for (const std::uint32_t radius : {0u, 5u, 30u}) {
    for (const double turns : {-0.5, -1.0, -7.0}) {  // clockwise: towards the wall
      const Move move = turning(turns, {-80, 0, 0});
      const BodyMotion motion(Pose::translated(-80, 0, 0), &move, 1);
      const double angle = std::asin((80.0 - radius) / 100);
      const double time = angle / (-turns * 2 * kPi);
      const double speed = -turns * 2 * kPi * 100 * std::cos(angle);
      check_meets(wall(), point.mesh(), motion, radius, time, speed);
    }
  }
  const Move move = turning(3, {-110, 0, 0});
  check_passes(wall(), point.mesh(), BodyMotion(Pose::translated(-110, 0, 0), &move, 1), 8);
}

TEST_CASE("a capsule meets a wall with the end that is ahead") {
  const SegmentShape segment(some_mesh(), {0, -50, 0}, {0, 50, 0});
  check_meets(wall(), segment.mesh(), straight({-200, 0, 0}, {400, 0, 0}), 10, 190.0 / 400, 400);
  const Move move = turning(-0.25, {-30, 0, 0});  // its upper end turns down to the wall
  const double angle = std::asin(20.0 / 50);
  check_meets(wall(), segment.mesh(), BodyMotion(Pose::translated(-30, 0, 0), &move, 1), 10,
              angle / (kPi / 2), kPi / 2 * 50 * std::cos(angle));
}

TEST_CASE("a screw drives a ball to a plate, through a chain of moves as well") {
  const BoxShape plate(some_mesh(), {-500, -500, 300}, {500, 500, 320});
  const PointShape point(some_mesh(), {40, 0, 0});
  const Move screw = turning(7, {0, 0, 0}, 400);
  const Move chain[] = {turning(-2, {10, 0, 0}), screw, turning(1, {40, 0, 0})};
  const Pose from = Pose::translated(0, 0, 0);
  check_meets(plate.mesh(), point.mesh(), BodyMotion(from, &screw, 1), 20, 280.0 / 400, 400);
  check_meets(plate.mesh(), point.mesh(), BodyMotion(from, chain, 3), 20, 280.0 / 400, 400);
}

TEST_CASE("a box slides along a wall, rests on it, or meets it with an edge") {
  const BoxShape box(some_mesh(), {-20, -10, -10}, {0, 10, 10});
  check_passes(wall(), box.mesh(), straight({-2, -400, 0}, {0, 800, 0}), 0);
  check_meets(wall(), box.mesh(), straight({0, -400, 0}, {0, 800, 0}), 0, 0, 800);
  check_meets(wall(), box.mesh(), straight({0, 0, 0}, {-100, 0, 0}), 0, 0, 100);
  check_meets(wall(), box.mesh(), straight({-100, 0, 0}, {100, 0, 0}), 0, 1, 100);
  // It turns about its middle, 14 cells from the wall and 10 sqrt 2 from its edges.
  const Move move = turning(1, {-14, 0, 0});
  const BodyMotion motion(Pose::translated(-4, 0, 0), &move, 1);
  const double angle = kPi / 4 - std::acos(14 / std::sqrt(200.0));
  check_meets(wall(), box.mesh(), motion, 0, angle / (2 * kPi), 2 * kPi * 10);
}

TEST_CASE("a motion that ends next to its way is tested where it ends") {
  // Stretched by 6 parts in 10^5 at its end, which still counts as a rotation: by six cells.
  constexpr int32_t far = 100'000;
  const SegmentShape segment(some_mesh(), {far - 100, 0, 0}, {far, 0, 0});
  const BoxShape box(some_mesh(), {far + 4, -5, -5}, {far + 12, 5, 5});
  constexpr int32_t longer = kRotationOne + kRotationOne / 16'500;
  const int32_t rotation[3][3] = {{longer, 0, 0}, {0, longer, 0}, {0, 0, longer}};
  const Pose to = Pose::rigid(rotation, {0, 0, 0});
  const BodyMotion motion = BodyMotion::between(Pose::translated(0, -100, 0), to);
  REQUIRE(motion.status() == Status::done);
  REQUIRE(intersects(box.mesh(), segment.mesh(), to).yes);
  const FirstContactAnswer answer =
      FirstContact(box.mesh(), segment.mesh(), motion).run(UINT32_MAX);
  CHECK(answer.status == Status::done);
  CHECK(answer.outcome != ContactOutcome::free);
}

TEST_CASE("motions that a first contact refuses") {
  const PointShape point(some_mesh(), {0, 0, 0});
  const auto status = [&](const BodyMotion& motion, std::uint32_t within = 0) {
    return FirstContact(wall(), point.mesh(), motion, {within}).run(1).status;
  };
  const BodyMotion still = straight({0, 0, 0}, {0, 0, 0});
  CHECK(status(still, kMaxMotionDistance + 1) == Status::distance_out_of_range);
  CHECK(status(straight({1 << 19, 0, 0}, {0, 0, 0})) == Status::motion_out_of_range);
  CHECK(status(straight({-(1 << 18), 0, 0}, {1 << 19, 0, 0})) == Status::motion_out_of_range);
  CHECK(status(straight({1 << 21, 0, 0}, {0, 0, 0})) == Status::motion_out_of_range);
  CHECK(status(straight({0, 0, 0}, {0, 1 << 21, 0})) == Status::motion_out_of_range);
  CHECK(status(straight({1 << 30, 0, 0}, {0, 0, 0})) == Status::translation_out_of_range);
  Move move = turning(1);
  move.axis[2] -= kRotationOne >> 13;
  CHECK(status(BodyMotion(still.from(), &move, 1)) == Status::not_a_rotation);
  move.axis[2] = kRotationOne;
  CHECK(status(BodyMotion(still.from(), &move, 1)) != Status::not_a_rotation);
  CHECK(status(BodyMotion(still.from(), nullptr, 0)) == Status::suspended);
  const std::vector<Move> laps(kMostMoves,
                               turning(7.9, {4000, 0, 0}));  // of 2^19 cells: a path of 10^9
  CHECK(status(BodyMotion(still.from(), laps.data(), kMostMoves)) == Status::motion_out_of_range);
  const PointShape far(some_mesh(), {1 << 18, 0, 0});
  CHECK(FirstContact(wall(), far.mesh(), still).status() == Status::motion_out_of_range);
}

TEST_CASE("a close point is as near as the query says, if its path misses the end's matrix") {
  // `to` is 1 + 2^-14 times a rotation: it puts the point 6.1 cells beyond the end of the moves.
  constexpr int32_t kOut = 100'000;
  constexpr int32_t kEntry = kRotationOne + (kRotationOne >> 14) - (1 << 10);
  const int32_t larger[3][3] = {{kEntry, 0, 0}, {0, kEntry, 0}, {0, 0, kEntry}};
  const PointShape point(some_mesh(), {0, kOut, 0});
  bool was_far = false;
  for (int32_t off = 1; off < 20; ++off) {
    const BodyMotion motion = BodyMotion::between(Pose::translated(-off, -kOut - 100, 0),
                                                  Pose::rigid(larger, {-off, -kOut + 100, 0}));
    FirstContact query(wall(), point.mesh(), motion);
    const FirstContactAnswer answer = query.run(UINT32_MAX);
    CAPTURE(off, query.close_distance());
    REQUIRE(answer.status == Status::done);
    const bool is_close = answer.outcome == ContactOutcome::close;
    CHECK((!is_close || query.close_distance() >= static_cast<uint32_t>(off) * 256));
    was_far = was_far || (is_close && off > 2);
  }
  CHECK(was_far);
}

TEST_CASE("bodies that stay farther apart than the largest distance are not close") {
  const PointShape point(some_mesh(), {0, 0, 0});
  const auto outcome = [&](int32_t apart, std::uint32_t within) {
    const BodyMotion motion = straight({-apart, -400, 0}, {0, 800, 0});
    return FirstContact(wall(), point.mesh(), motion, {within}).run(UINT32_MAX).outcome;
  };
  CHECK(outcome(32'003, kMaxMotionDistance) == ContactOutcome::free);
  CHECK(outcome(31'990, kMaxMotionDistance) == ContactOutcome::contact);
}
