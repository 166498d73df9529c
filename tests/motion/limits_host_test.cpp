// First contacts at the limits of motions: refused ones, inexact matrices, the largest distance.
#include "flashbvh/shape.hpp"
#include "support/motion_scene.hpp"
#include "support/test.hpp"

namespace {

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

BodyMotion straight(const Point& from, const Point& way) {
  return Translation{from, way}.motion();
}

}  // namespace

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
  Move move = {{0, 0, 0}, {0, 0, kRotationOne - (kRotationOne >> 13)}, kFullTurn, {0, 0, 0}};
  CHECK(status(BodyMotion(still.from(), &move, 1)) == Status::not_a_rotation);
  move.axis[2] = kRotationOne;
  CHECK(status(BodyMotion(still.from(), &move, 1)) != Status::not_a_rotation);
  CHECK(status(BodyMotion(still.from(), nullptr, 0)) == Status::suspended);
  const Move lap = {{4000 * kFrameCell, 0, 0}, {0, 0, kRotationOne}, 7 * kFullTurn, {0, 0, 0}};
  const std::vector<Move> laps(kMostMoves, lap);  // of 2^19 cells: a path of 10^9
  CHECK(status(BodyMotion(still.from(), laps.data(), kMostMoves)) == Status::motion_out_of_range);
  const PointShape far(some_mesh(), {1 << 18, 0, 0});
  CHECK(FirstContact(wall(), far.mesh(), still).status() == Status::motion_out_of_range);
}

TEST_CASE("a motion that ends next to its path is tested where it ends") {
  // Stretched by 6 parts in 10^5 at its end, which still counts as a rotation: by six cells.
  constexpr int32_t far = 100'000;
  const SegmentShape segment(some_mesh(), {far - 100, 0, 0}, {far, 0, 0});
  const BoxShape box(some_mesh(), {far + 4, -5, -5}, {far + 12, 5, 5});
  constexpr int32_t longer = kRotationOne + kRotationOne / 16'500;
  const int32_t rotation[3][3] = {{longer, 0, 0}, {0, longer, 0}, {0, 0, longer}};
  const Pose to = Pose::rigid(rotation, {0, 0, 0});
  const BodyMotion motion = BodyMotion::between(Pose::translated(0, -100, 0), to);
  REQUIRE(intersects(box.mesh(), segment.mesh(), to).yes);
  const FirstContactAnswer answer =
      FirstContact(box.mesh(), segment.mesh(), motion).run(UINT32_MAX);
  CHECK(answer.status == Status::done);
  CHECK(answer.outcome != ContactOutcome::free);
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
