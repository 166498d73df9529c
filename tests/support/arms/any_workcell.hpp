// Random arms with a tool, a post and a moving obstacle, and their frames in doubles.
#pragma once

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include "flashbvh/robot/workcell.hpp"
#include "support/arms/guarded_arm.hpp"

namespace flashbvh::test {

constexpr double kWorkcellCell = 2e-3;

using AnyWorkcell = WorkcellOf<12, 16, 64, 128>;
using WorkcellState = GuardStateOf<12, 64, 512>;

inline Frame fixed_frame(const Transform& transform) {
  return tool::fixed_frame(transform, kWorkcellCell);
}

inline Transform any_transform(Random& random, double far) {
  Transform made;
  for (int turn = 0; turn < 2; ++turn) {
    const std::size_t axis = random.below(3);
    made = composed(made, turned(axis, real_between(random, -4, 4)));
  }
  for (double& t : made.translation) {
    t = real_between(random, -far, far);
  }
  return made;
}

/// An obstacle's motion in one period: a translation, and a turn about an axis of its own.
struct Way {
  Transform from;
  Vector3 along{};
  std::size_t axis = 0;
  double angle = 0;

  Transform at(double part) const {
    return composed(shifted({along[0] * part, along[1] * part, along[2] * part}),
                    composed(from, turned(axis, angle * part)));
  }
  /// An upper bound of the travel of any point within `radius` of its origin, in 1/256 cell.
  std::uint32_t length(double radius) const {
    const double most = std::hypot(along[0], along[1], along[2]) + std::abs(angle) * radius;
    return static_cast<std::uint32_t>(most / kWorkcellCell * 256) + 2;
  }
};

/// A box far smaller than an arm.
struct Body {
  explicit Body(Random& random)
      : size{real_between(random, 0.01, 0.1), real_between(random, 0.01, 0.2),
             real_between(random, 0.01, 0.1)},
        low{real_between(random, -0.1, 0), real_between(random, -0.1, 0),
            real_between(random, -0.1, 0)} {
    add_link(model, tool::kNoJoint,
             box(low, {low[0] + size[0], low[1] + size[1], low[2] + size[2]}));
    baked = std::make_unique<BakedArm>(model, kWorkcellCell);
  }
  const Mesh& mesh() const { return baked->meshes()[0]; }
  double radius() const { return 0.4; }

  Vector3 size;
  Vector3 low;
  Model model;
  std::unique_ptr<BakedArm> baked;
};

/// An arm with a tool, a post and a moving obstacle.
struct CrowdedCell {
  explicit CrowdedCell(Random& random)
      : arm(any_guarded_arm(random, 3 + random.below(2), kWorkcellCell)),
        tool(random),
        post(random),
        moving(random),
        workcell(arm.robot(), memory),
        tool_joint(random.below(static_cast<std::uint32_t>(arm.model.joints.size()))),
        tool_at(any_transform(random, 0.1)),
        post_at(any_transform(random, 0.8)) {
    way.from = any_transform(random, 1);
    const auto joint = static_cast<std::uint8_t>(tool_joint);
    REQUIRE(workcell.add(tool.mesh(), {joint, fixed_frame(tool_at)}, links[0]) == Status::done);
    REQUIRE(workcell.add(post.mesh(), {kBase, fixed_frame(post_at)}, links[1]) == Status::done);
    REQUIRE(workcell.add(moving.mesh(), {kBase, fixed_frame(way.from)}, links[2]) == Status::done);
    for (std::uint8_t a = 0; a < robot().link_count; ++a) {
      for (const std::uint8_t b : links) {
        const std::uint32_t stop = random.below(2000);
        if (a < b && !(robot().links[a].joint == tool_joint && b == links[0]) &&
            !(robot().links[a].joint == kBase && b != links[0]) &&
            !(a == links[1] && b == links[2])) {
          REQUIRE(workcell.keep_apart(a, b, {stop}, {stop + random.below(4000)}) == Status::done);
        }
      }
    }
  }
  const Robot& robot() const { return workcell.robot(); }

  /// Moves the obstacle; the new frame counts from the next period.
  Status move(Random& random, double speed) {
    way.from = way.at(1);
    way.axis = random.below(3);
    way.angle = random.below(3) == 0 ? 0 : real_between(random, -speed, speed);
    for (double& t : way.along) {
      t = random.below(4) == 0 ? 0 : real_between(random, -speed, speed) * 0.3;
    }
    return workcell.move(links[2], fixed_frame(way.at(1)), {way.length(moving.radius())});
  }

  /// Moves a corner of the obstacle to a corner of the arm's last link.
  void put_on_a_link(const Values& values) {
    const auto last = static_cast<std::uint8_t>(arm.robot().link_count - 1);
    const Transform frame = frame_of(last, values, 1);
    way = {};
    for (std::size_t i = 0; i < 3; ++i) {
      way.from.translation[i] =
          placed(frame, arm.model.links[last].mesh.vertices[0])[i] - moving.low[i];
    }
    REQUIRE(workcell.move(links[2], fixed_frame(way.from), {1u << 27}) == Status::done);
  }

  Transform frame_of(std::uint8_t link, const Values& values, double part) const {
    const std::vector<Transform> frames = frames_of(arm.model, arm.variables(values));
    if (link < arm.robot().link_count) {
      const std::uint8_t joint = robot().links[link].joint;
      return joint == kBase ? Transform() : frames[joint];
    }
    return link == links[0]   ? composed(frames[tool_joint], tool_at)
           : link == links[1] ? post_at
                              : way.at(part);
  }
  bool is_closer(const RobotPair& pair, const Values& values, double part,
                 std::uint32_t distance) const {
    const Transform between =
        composed(inverse(frame_of(pair.a, values, part)), frame_of(pair.b, values, part));
    return closer_than(robot().meshes[pair.a], robot().meshes[pair.b],
                       tool::pose_of(between, kWorkcellCell),
                       {distance < kMaxGuardDistance ? distance : kMaxGuardDistance})
        .yes;
  }

  FixedArm arm;
  Body tool;
  Body post;
  Body moving;
  AnyWorkcell memory{};
  Workcell workcell;
  std::size_t tool_joint;
  Transform tool_at;
  Transform post_at;
  Way way;
  std::uint8_t links[3] = {};
};

/// A workcell, and values at which its guard does not stop.
inline std::unique_ptr<CrowdedCell> any_cell_apart(Random& random, Values& values) {
  for (;;) {
    auto cell = std::make_unique<CrowdedCell>(random);
    const auto state = std::make_unique<WorkcellState>();
    Guard guard(cell->robot(), *state);
    if (prime_apart(random, cell->arm, guard, 50, values).verdict != Verdict::stop) {
      return cell;
    }
  }
}

}  // namespace flashbvh::test
