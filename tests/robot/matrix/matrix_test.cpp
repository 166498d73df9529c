// Verdicts against formulas, and against brute force on random arms.
#include "robot/matrix/matrix.hpp"
#include "robot/matrix/pair_search.hpp"
#include "simplify/zoo.hpp"
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCell = 1e-3;

/// Decides the only pair, and checks the promises of any verdict.
PairVerdict decided(const Model& model, const MatrixOptions& options = {}) {
  const BakedArm arm(model, kCell);
  const std::vector<PairVerdict> pairs = arm.decide(options);
  REQUIRE(pairs.size() == 1);
  const PairVerdict& pair = pairs[0];
  if (pair.verdict == MatrixVerdict::can) {
    REQUIRE(arm.intersect(pair.a, pair.b, pair.witness));
    for (std::size_t i = 0; i < pair.witness.size(); ++i) {
      const Interval range = range_of_variable(model, i);
      REQUIRE(pair.witness[i] >= range.lower);
      REQUIRE(pair.witness[i] <= range.upper);
    }
  }
  REQUIRE_FALSE(pair.reason.empty());
  return pair;
}

MatrixVerdict verdict_of(const Model& model) {
  return decided(model).verdict;
}

/// A rod of length 1 that turns about z from `lower` to `upper`, and a wall along x at y = `wall`.
Model rod_and_wall(double lower, double upper, double wall) {
  Model model;
  add_link(model, kNoJoint, box({-2, wall, -0.5}, {2, wall + 0.1, 0.5}));
  const std::size_t joint = add_joint(model, kNoJoint, {}, JointType::revolute, lower, upper);
  add_link(model, joint, box({0.2, -0.001, -0.1}, {1, 0.001, 0.1}));
  return model;
}

/// The angle at which the rod's corner (1, 0.001) has this y.
double angle_at(double y) {
  return std::asin(y / std::hypot(1, 0.001)) - std::atan2(0.001, 1);
}

}  // namespace

TEST_CASE("limits that just allow contact, and that just forbid it") {
  // The slack is 1.78 cells and the resolution half a cell: a pair four cells away is decided.
  for (const double wall : {0.3, 0.7, 0.9}) {
    CAPTURE(wall);
    CHECK(verdict_of(rod_and_wall(-1, angle_at(wall + kCell), wall)) == MatrixVerdict::can);
    CHECK(verdict_of(rod_and_wall(-1, angle_at(wall - 4 * kCell), wall)) == MatrixVerdict::never);
    // Within the slack, verdicts are undecided.
    CHECK(verdict_of(rod_and_wall(-1, angle_at(wall - 1.2 * kCell), wall)) ==
          MatrixVerdict::undecided);
    // The other end of the interval.
    CHECK(verdict_of(rod_and_wall(angle_at(wall + kCell) - kPi, 0, -wall - 0.1)) ==
          MatrixVerdict::can);
  }
}

TEST_CASE("a link of more triangles than 16 bits count is decided, with a witness") {
  // The wall is a flat grid: 350 by 100 squares from x = -2 to 0.9. The rod meets it at about 0.8,
  // among the last triangles.
  constexpr double kWall = 0.5;
  constexpr double kWide = 2.9 / 350;
  const bake::SourceMesh wall = grid(350, 100, false, [&](double u, double v) -> Vector3 {
    return {2.9 * u - 2, kWall, v - 0.5};
  });
  REQUIRE(wall.triangles.size() == 70'000);
  const auto verdict_up_to = [&](double y) {
    Model model = rod_and_wall(-1, angle_at(y), kWall);
    model.links[0].mesh = wall;
    const std::vector<BakedPart> parts = {bake_part(wall, kCell),
                                          bake_part(model.links[1].mesh, kCell)};
    const std::vector<WholeMesh> meshes = views_of(parts);
    const PairVerdict pair =
        decide_pairs(model, meshes, {}, all_reaches(model, kCell), kCell, {}, {})[0];
    if (pair.verdict == MatrixVerdict::can) {
      CHECK(pair.witness[0] > angle_at(kWall - kCell));
      CHECK(pair.witness[0] <= range_of_variable(model, 0).upper);
      const auto lit = triangles_at(model, meshes, kCell, pair);
      // The middle of the rod at the wall, and the extent of the rod and of rounding.
      const double at = kWall / std::tan(pair.witness[0]);
      const double near = 0.001 / std::sin(pair.witness[0]) + 3 * kCell + kWide;
      CHECK(lit.a > UINT16_MAX);
      for (const std::uint32_t corner : wall.triangles[lit.a]) {
        CHECK(wall.vertices[corner][0] == Approx(at).margin(near));
        CHECK(std::fabs(wall.vertices[corner][2]) < 0.1 + 0.01 + kCell);
      }
    }
    return pair.verdict;
  };
  CHECK(verdict_up_to(kWall + 10 * kCell) == MatrixVerdict::can);
  CHECK(verdict_up_to(kWall - 4 * kCell) == MatrixVerdict::never);
}

TEST_CASE("a witness lies well inside of where they intersect") {
  const double wall = 0.5;
  for (const double upper : {0.6, 1.0, 1.5}) {
    CAPTURE(upper);
    const double witness = decided(rod_and_wall(-1, upper, wall)).witness[0];
    const double first = angle_at(wall);
    CHECK(witness > first + (upper - first) / 5);
    CHECK(witness <= upper);
  }
}

TEST_CASE("intervals are closed: contact at a limit alone is found") {
  for (const bool upper : {true, false}) {
    // Slides along z until the two faces lie in one plane: they touch there and nowhere else.
    Model model;
    add_link(model, kNoJoint, box({0, 0, 0}, {0.1, 0.1, 0.1}));
    const std::size_t joint =
        upper ? add_joint(model, kNoJoint, shifted({0, 0, -0.5}), JointType::prismatic, 0, 0.25)
              : add_joint(model, kNoJoint, shifted({0, 0, 0.5}), JointType::prismatic, -0.25, 0);
    const double face = upper ? 0.25 : -0.15;
    add_link(model, joint, box({0, 0, face}, {0.1, 0.1, face}));
    CHECK(verdict_of(model) == MatrixVerdict::can);
    model.joints[0].upper -= upper ? 4 * kCell : 0;
    model.joints[0].lower += upper ? 0 : 4 * kCell;
    CHECK(verdict_of(model) == MatrixVerdict::never);
  }
}

TEST_CASE("a continuous joint covers the full turn") {
  // The rod meets the wall only at the seam, at the angle pi.
  Model model;
  add_link(model, kNoJoint, box({-1.2, -0.0005, -0.1}, {-0.9, 0.0005, 0.1}));
  const std::size_t joint = add_joint(model, kNoJoint, {}, JointType::continuous, -kPi, kPi);
  add_link(model, joint, box({0.2, -0.0005, -0.1}, {1, 0.0005, 0.1}));
  CHECK(verdict_of(model) == MatrixVerdict::can);
  // A rod that ends before the wall.
  model.links[1].mesh = box({0.2, -0.0005, -0.1}, {0.9 - 4 * kCell, 0.0005, 0.1});
  CHECK(verdict_of(model) == MatrixVerdict::never);
  // Slightly less than a full turn, on both sides of the seam.
  model = rod_and_wall(-kPi + 0.02, kPi - 0.02, 0);
  model.links[0].mesh = box({-1.2, -0.0005, -0.1}, {-0.9, 0.0005, 0.1});
  CHECK(verdict_of(model) == MatrixVerdict::never);
}

TEST_CASE("what never collides is guarded if it comes within the stop distance") {
  constexpr double kGap = 0.05;
  for (const double wall : {0.3, 0.7, 0.9}) {
    CAPTURE(wall);
    const Model model = rod_and_wall(-1, angle_at(wall - kGap), wall);
    const auto stopping_at = [&](double stop) {
      MatrixOptions options;
      options.stop = stop / kCell;
      const PairVerdict pair = decided(model, options);
      CHECK(pair.verdict == MatrixVerdict::never);
      return pair;
    };
    CHECK_FALSE(stopping_at(0).is_guarded);
    CHECK_FALSE(stopping_at(kGap - 4 * kCell).is_guarded);
    const PairVerdict guarded = stopping_at(kGap + 4 * kCell);
    CHECK(guarded.is_guarded);
    CHECK_FALSE(guarded.is_stopped);
    CHECK(stopping_at(3).is_stopped);
    // Each proof counts its own joint boxes.
    const PairVerdict alone = stopping_at(0);
    CHECK(alone.reason == "proven for all values within the limits, " +
                              std::to_string(alone.joint_boxes) + " joint boxes");
    CHECK(guarded.reason == alone.reason + "; " +
                                std::to_string(guarded.joint_boxes - alone.joint_boxes) +
                                " more for --stop");
  }
}

TEST_CASE("prismatic joints: gaps by subtraction") {
  for (const double gap : {4 * kCell, -kCell}) {
    // Two fingers of a hand that close from both sides.
    Model model;
    const double stroke = (0.2 - gap) / 2;
    const std::size_t left =
        add_joint(model, kNoJoint, turned(1, kPi / 2), JointType::prismatic, 0, stroke);
    const std::size_t right =
        add_joint(model, kNoJoint, turned(1, -kPi / 2), JointType::prismatic, 0, stroke);
    add_link(model, left, box({-0.01, -0.01, -0.12}, {0.01, 0.01, -0.1}));
    add_link(model, right, box({-0.01, -0.01, -0.12}, {0.01, 0.01, -0.1}));
    CHECK(verdict_of(model) == (gap > 0 ? MatrixVerdict::never : MatrixVerdict::can));
    // One variable moves both: the second finger mimics the first, with gear ratio 1 or 3.
    for (const double gear : {1.0, 3.0}) {
      Model mimic;
      const Transform right_frame = model.joints[right].fixed;
      add_joint(mimic, kNoJoint, model.joints[left].fixed, JointType::prismatic, 0,
                2 * stroke / (1 + gear));
      add_mimic(mimic, kNoJoint, right_frame, JointType::prismatic, 0, gear, 0);
      mimic.links = model.links;
      const PairVerdict closed = decided(mimic);
      CHECK(closed.verdict == (gap > 0 ? MatrixVerdict::never : MatrixVerdict::can));
      CHECK(closed.witness.size() == (gap > 0 ? 0 : 1));
    }
  }
}

TEST_CASE("mimics move with their master, not by themselves") {
  // The forearm turns back by the upper arm's angle: it keeps its direction, and never meets the
  // body that it could meet with two free joints.
  Model model;
  add_link(model, kNoJoint, box({-0.1, 1.2, -0.5}, {0.1, 1.3, 0.5}));
  const std::size_t shoulder = add_joint(model, kNoJoint, {}, JointType::revolute, -kPi, kPi);
  const std::size_t elbow =
      add_mimic(model, shoulder, shifted({1, 0, 0}), JointType::revolute, 0, -1, 0);
  add_link(model, elbow, box({0.2, -0.01, -0.01}, {0.6, 0.01, 0.01}));
  CHECK(verdict_of(model) == MatrixVerdict::never);
  model.joints[elbow].multiplier = 1;
  CHECK(verdict_of(model) == MatrixVerdict::can);
  model.joints[elbow].multiplier = -1;
  model.joints[elbow].offset = kPi / 2;
  model.links[0].mesh = box({-0.1, 1.4, -0.5}, {0.1, 1.5, 0.5});
  CHECK(verdict_of(model) == MatrixVerdict::can);
}

TEST_CASE("what an SRDF disables is decided as any pair") {
  Model model = rod_and_wall(-1, 1, 0.5);
  model.disabled = {{1, 0, "Never", 7}};
  CHECK(decided(model).is_guarded);
  model.disabled[0].is_believed = true;
  CHECK_FALSE(decided(model).is_guarded);
  // A pair too near to decide is guarded, unless it is believed.
  model.joints[0].upper = angle_at(0.5 - 1.2 * kCell);
  CHECK(verdict_of(model) == MatrixVerdict::believed);
  model.disabled[0].is_believed = false;
  CHECK(verdict_of(model) == MatrixVerdict::undecided);
  CHECK(decided(model).is_guarded);
  // A pair that never collides is not guarded for the stop distance.
  model.joints[0].upper = angle_at(0.45);
  MatrixOptions options;
  options.stop = 0.1 / kCell;
  CHECK(decided(model, options).verdict == MatrixVerdict::never);
  CHECK_FALSE(decided(model, options).is_guarded);
  options.own = {{0, 1, options.stop, options.stop}};
  CHECK(decided(model, options).is_guarded);
}

TEST_CASE("more than a turn is looked at over one") {
  for (const double rod : {0.5, 0.4 - 4 * kCell}) {
    CAPTURE(rod);
    const auto model = [&](double half) {
      Model made = rod_and_wall(0.7 - half, 0.7 + half, 0.4);
      made.links[1].mesh = box({0.2, -0.001, -0.1}, {rod, 0.001, 0.1});
      return made;
    };
    const PairVerdict turn = decided(model(kPi));
    const PairVerdict more = decided(model(3 * kPi));
    CHECK(turn.verdict == (rod > 0.4 ? MatrixVerdict::can : MatrixVerdict::never));
    CHECK(more.verdict == turn.verdict);
    CHECK(more.joint_boxes == turn.joint_boxes);
    CHECK(more.reason == turn.reason);
  }
}

TEST_CASE("when the time is up, the rest is undecided, and guarded") {
  MatrixOptions late;
  late.deadline = in_seconds(Clock::now(), -1);
  for (const double wall : {0.5, 1.5}) {
    CAPTURE(wall);
    const Model model = rod_and_wall(-1, 1, wall);
    const PairVerdict pair = decided(model, late);
    CHECK(pair.verdict == MatrixVerdict::undecided);
    CHECK(pair.reason ==
          "neither proven nor found to intersect after 0 joint boxes, when its time was up");
    CHECK(pair.is_guarded);
    CHECK(pair.joint_boxes == 0);
    const BakedArm arm(model, kCell);
    const PairSpace space(model, {0, arm.wholes()[0]}, {1, arm.wholes()[1]}, kCell);
    CHECK_FALSE(find_intersection(space, late, 256));
    std::uint32_t visits = 0;
    space.find_near({0.0}, kMaxGuardDistance,
                    [&](std::uint32_t, std::uint32_t) { return ++visits < 2; });
    CHECK(visits == 2);
    std::uint64_t cells = 0;
    CHECK_FALSE(is_proven_swept(model, 0, 1, kCell, late, cells));
    CHECK(cells == 0);
  }
}

TEST_CASE("plates that slide side by side end") {
  const auto plates = [](double gap) {
    Model model;
    const std::size_t x =
        add_joint(model, kNoJoint, turned(1, kPi / 2), JointType::prismatic, -0.5, 0.5);
    const std::size_t y = add_joint(model, x, turned(0, kPi / 2), JointType::prismatic, -0.5, 0.5);
    // Turns back to the base's axes.
    Transform back = inverse(composed(turned(1, kPi / 2), turned(0, kPi / 2)));
    const std::size_t spin = add_joint(model, y, back, JointType::continuous, -kPi, kPi);
    add_link(model, kNoJoint, box({-1, -1, -0.1}, {1, 1, 0}));
    add_link(model, spin, box({-0.5, -0.5, gap}, {0.5, 0.5, 0.1}));
    return model;
  };
  MatrixOptions options;
  options.most_joint_boxes = 3000;
  CHECK(decided(plates(0.1 * kCell), options).verdict ==
        MatrixVerdict::can);  // rounded: they touch
  const PairVerdict close = decided(plates(5 * kCell), options);
  CHECK(close.verdict == MatrixVerdict::undecided);
  CHECK(close.joint_boxes <= 2 * options.most_joint_boxes);
}
