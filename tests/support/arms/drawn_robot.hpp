// A robot as firmware has it and as drawn, for tests that judge a guard by force. The judge places
// the URDF's links in doubles and shares no code with the library. Parts outside a joint's zone are
// as baked.
//
// FLASHBVH_SAMPLE=N: the robot follows each command in N periods of update(), one of them judged.
#pragma once

#include "flashbvh/robot/workcell.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/oracles/drawn_mesh.hpp"
#include "support/test.hpp"

namespace flashbvh::tool {

inline constexpr double kTurnSpeed = 3e-3;   ///< radians a period
inline constexpr double kSlideSpeed = 2e-4;  ///< metres a period

/// A robot in a workcell, with a box that goes from place to place.
struct Room {
  Room(const Robot& robot, std::size_t links, Random& numbers)
      : random(numbers), workcell(robot, *memory), cell(cell_of(robot)) {
    Model model;
    add_link(model, kNoJoint, box({-0.03, -0.03, -0.03}, {0.03, 0.03, 0.03}));
    body = std::make_unique<BakedArm>(model, cell);
    const auto fine = [&](double metres) {
      return FineLength{static_cast<std::uint32_t>(metres / cell * kFineOne)};
    };
    REQUIRE(workcell.add(body->meshes()[0], {kBase, kIdentityFrame}, obstacle) == Status::done);
    for (std::uint8_t link = 0; link < links; ++link) {
      if (robot.links[link].joint != kBase) {
        REQUIRE(workcell.keep_apart(link, obstacle, fine(0.01), fine(0.03)) == Status::done);
      }
    }
  }
  /// One period. `next`: of the robot, where the box goes after its last goal.
  void move(const std::vector<Transform>& next) {
    double left = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      from.translation[i] = to.translation[i];
      left = std::max(left, std::abs(goal[i] - from.translation[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const double part = std::min(1.0, speed / std::max(left, 1e-9));
      to.translation[i] += part * (goal[i] - from.translation[i]);
    }
    if (left < speed) {
      goal = random.one_of(next).translation;
      const double speeds[] = {2e-5, 2e-4, 2e-3};
      speed = random.one_of(speeds);
    }
    const double way = std::sqrt(squared(minus(to.translation, from.translation)));
    const auto moved = static_cast<std::uint32_t>(way / cell * kFineOne) + 2;
    REQUIRE(workcell.move(obstacle, fixed_frame(to, cell), {moved}) == Status::done);
  }

  Random& random;
  std::unique_ptr<WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>> memory =
      std::make_unique<WorkcellOf<kMaxJoints, kMaxLinks, 512, 4096>>();
  Workcell workcell;
  double cell;
  std::unique_ptr<BakedArm> body;
  std::uint8_t obstacle = 0;
  Transform from;  ///< in this period
  Transform to;
  Vector3 goal{};
  double speed = 0;
};

/// Where a pair was seen apart last, in metres. A test that asks for more lasts longer.
struct Apart {
  Transform frame;
  double distance = 0;
  double more = 1e-3;
};

/// A robot as firmware has it and as drawn, and places of it. Distances are in 1/256 cell.
struct Drawn {
  Drawn(const Robot& of, Model as_drawn, Random& numbers, Room* with = nullptr)
      : robot(of), model(std::move(as_drawn)), random(numbers), room(with) {
    for (std::uint32_t i = 0; i < robot.link_count; ++i) {
      meshes.emplace_back(i < model.links.size() ? triangles_of(model.links[i].mesh)
                                                 : as_baked(robot.meshes[i]));
      rounding = std::min(rounding, double(robot.slack) - 2.0 * robot.links[i].deviation);
    }
    for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
      int near = 0;
      while (near < 400 && is_within(i, any(), limit(i, 1, 2))) {
        ++near;
      }
      left_out.push_back(near == 400);
    }
  }

  std::vector<FloatTriangle> as_baked(const Mesh& mesh) const {
    const std::vector<Vector3> vertices = vertices_of(mesh);
    std::vector<FloatTriangle> triangles(mesh.triangle_count);
    for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
      triangles[i / 3][i % 3] = times(cell, vertices[mesh.triangles[i / 3].corner[i % 3]]);
    }
    return triangles;
  }
  std::string name_of(std::size_t i) const {
    const auto name = [&](std::size_t link) {
      return link < model.links.size() ? model.links[link].name : "part " + std::to_string(link);
    };
    return name(robot.pairs[i].a) + " - " + name(robot.pairs[i].b);
  }
  double give(std::size_t i) const { return std::max(robot.pairs[i].stop / 10.0, 8 * rounding); }
  double deviation(std::size_t i) const {
    return double(robot.links[robot.pairs[i].a].deviation) +
           robot.links[robot.pairs[i].b].deviation;
  }
  /// A part of the stop distance, as measured, and of the give.
  double limit(std::size_t i, double part, double gives) const {
    return part * (double(robot.pairs[i].stop) + robot.slack) + gives * give(i);
  }
  /// What a floor promises.
  double kept(std::size_t i, double floor) const {
    return floor - std::min(give(i), floor / 2) - deviation(i);
  }
  double unit_of(std::size_t variable) const {
    return unit_of_coordinate(robot.joints[model.variables[variable]].type, cell);
  }
  /// `moment`: of the period's motion of an obstacle.
  std::vector<Transform> frames(const Values& values, double moment) const {
    std::vector<double> variables;
    for (std::size_t i = 0; i < values.size(); ++i) {
      variables.push_back(values[i] * unit_of(i));
    }
    std::vector<Transform> all = frames_of(model, variables);
    if (room != nullptr) {
      all.push_back(room->to);
      const Vector3 back = minus(room->from.translation, room->to.translation);
      all.back().translation = plus(room->to.translation, 1 - moment, back);
    }
    return all;
  }
  bool has_obstacle(std::size_t i) const {
    return room != nullptr && robot.pairs[i].b == room->obstacle;
  }
  bool is_nearer(std::size_t i, const std::vector<Transform>& frames, double distance) {
    const RobotPair& of = robot.pairs[i];
    const auto frame_of = [&](std::size_t link) {
      const std::size_t joint = joint_of(robot.links[link].joint);
      return joint == kNoJoint ? Transform() : frames[joint];
    };
    const Transform frame = composed(inverse(frame_of(of.a)), frame_of(of.b));
    const double asked = distance * cell / kFineOne;
    Apart& last = apart[i];
    const auto is_apart = [&](double more) {
      return !meshes[of.a].is_nearer(meshes[of.b], frame, asked + more);
    };
    if (last.distance - meshes[of.b].way(last.frame, frame) > asked) {
      return false;
    }
    const bool is_far = is_apart(last.more);
    const bool is = !is_far && !is_apart(0);
    last.frame = frame;
    last.distance = is ? 0 : asked + (is_far ? last.more : 0);
    last.more = std::clamp(last.more * (is_far ? 2 : 0.25), 1e-5, 0.1);
    return is;
  }
  /// As baked: only for starts and for success.
  bool is_within(std::size_t i, const Values& at, double distance) const {
    const RobotPair& of = robot.pairs[i];
    const PlacedLinks links(robot, coordinates_of(robot, at));
    const FineLength length = {std::min(static_cast<std::uint32_t>(distance), kMaxGuardDistance)};
    return closer_than(robot.meshes[of.a], robot.meshes[of.b], links.pose(of.a, of.b), length).yes;
  }
  /// Whether any pair is, or within `more`; if `part` is 0, a pair that is left out counts, too.
  bool is_near(const Values& at, double part, double gives, double more = 0) const {
    bool is = false;
    for (std::size_t i = 0; !is && i < robot.pair_count; ++i) {
      is = (part == 0 || !left_out[i]) && is_within(i, at, limit(i, part, gives) + more);
    }
    return is;
  }
  Values any() const {
    Values values;
    for (const std::size_t number : model.variables) {
      const RobotJoint& joint = robot.joints[number];
      const std::int32_t half = joint.type == JointType::continuous ? kFullTurn / 2 - 1 : 0;
      values.push_back(
          random.between(half == 0 ? joint.lower : -half, half == 0 ? joint.upper : half));
    }
    return values;
  }
  /// Any place that is near, or is not; the last one tried if none is found.
  Values any(bool is, double part, double gives) const {
    Values values = any();
    for (int i = 0; i < 400 && is_near(values, part, gives) != is; ++i) {
      values = any();
    }
    return values;
  }
  Values free_place() const { return any(false, 1, 2); }
  /// Where pairs get near on the way from a free place.
  Values border(Values to, double part, double gives) const {
    Values from = free_place();
    for (int i = 0; i < 24; ++i) {
      const Values middle = between(from, to, 0.5);
      (is_near(middle, part, gives) ? to : from) = middle;
    }
    return to;
  }
  /// Inside and not intersecting, at any depth; or intersecting by some millimetres of motion. The
  /// last place tried if none is found.
  Values start(bool intersects) const {
    Values at;
    bool is = false;
    for (int i = 0; !is && i < 200; ++i) {
      const Values wrong = any(true, 0, 0);
      const double depth = intersects ? 0 : std::pow(real_between(random, 0.17, 0.98), 2);
      at = !intersects && random.below(2) == 0 ? any() : border(wrong, depth, 0);
      at = intersects ? step(at, wrong, real_between(random, 0, 1)) : at;
      is = intersects ? is_near(at, 0, 0) : is_near(at, 1, 0) && !is_near(at, 0, 0, 5 * rounding);
    }
    return at;
  }
  static Values between(const Values& from, const Values& to, double part) {
    Values made = from;
    for (std::size_t i = 0; i < from.size(); ++i) {
      made[i] += static_cast<std::int32_t>(part * (double(to[i]) - from[i]));
    }
    return made;
  }
  /// A period's step.
  Values step(const Values& from, const Values& to, double speed) const {
    double periods = 1e-9;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const bool slides = robot.joints[model.variables[i]].type == JointType::prismatic;
      const double way = std::abs(double(to[i]) - from[i]) * unit_of(i);
      periods = std::max(periods, way / speed / (slides ? kSlideSpeed : kTurnSpeed));
    }
    return periods > 1 ? between(from, to, 1 / periods) : to;
  }

  const Robot& robot;
  Model model;
  Random& random;
  Room* room;
  double cell = cell_of(robot);
  double rounding = robot.slack;  ///< less deviations
  std::uint32_t sample = static_cast<std::uint32_t>(number_in("FLASHBVH_SAMPLE", 1));
  std::vector<DrawnMesh> meshes;
  std::vector<Apart> apart = std::vector<Apart>(robot.pair_count);
  std::vector<bool> left_out;  ///< pairs that are nowhere found far beyond their stop distance
};

}  // namespace flashbvh::tool
