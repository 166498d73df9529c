// Motions of every kind: chains of moves about near and far axes, whole and multiple turns, screws,
// translations, and motions between two poses.
#pragma once

#include <cmath>
#include <vector>

#include "support/motion_scene.hpp"
#include "support/oracles/exact_motion.hpp"

namespace flashbvh::test {

/// A motion between two poses, or a chain of moves.
struct AnyMotion {
  Pose from = Pose::translated(0, 0, 0);
  Pose to = from;           ///< used if there are no moves
  std::vector<Move> moves;  ///< if empty, the motion is between the poses

  BodyMotion motion() const {
    return moves.empty() ? BodyMotion::between(from, to)
                         : BodyMotion(from, moves.data(), static_cast<std::uint32_t>(moves.size()));
  }
  /// Translates the whole motion, axes included.
  void shift(const Point& by) {
    const Pose shift = Pose::translated(by.x, by.y, by.z);
    from = Pose::composed(shift, from);
    to = Pose::composed(shift, to);
    for (Move& move : moves) {
      for (int i = 0; i < 3; ++i) {
        move.point[i] += by.*kPointAxes[i] * kFrameCell;
      }
    }
  }
};

/// A pose with rotation entries of five decimals, so nearly a rotation.
inline Pose with_five_decimals(const Pose& pose) {
  int32_t rotation[3][3];
  int32_t cells[3];
  int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double entry = std::round(1e5 * pose.rotation(i, j) / kRotationOne) / 1e5;
      rotation[i][j] = static_cast<int32_t>(std::lround(entry * kRotationOne));
    }
    cells[i] = pose.translation(i);
    fraction[i] = static_cast<int16_t>(pose.fraction(i));
  }
  return Pose::rigid(rotation, cells, fraction);
}

/// A random move. `far`: the largest offset of its axis; `size`: the largest travel; in cells.
inline Move any_move(Random& random, int32_t far, int32_t size) {
  Move move = {};
  const Quaternion q = any_quaternion(random);
  const double length = std::hypot(q.x, q.y, q.z) * (1 + 1e-6 * random.between(-60, 60));
  const int32_t parts[] = {q.x, q.y, q.z};
  const int32_t turns[] = {kFullTurn / 100, kFullTurn / 4, kFullTurn / 2, kFullTurn, 7 * kFullTurn};
  const int32_t most = random.one_of(turns);
  move.turn = length == 0 ? 0 : random.below(2) == 0 ? random.between(-most, most) : most;
  const bool is_screw = random.below(3) == 0;
  const int32_t pitch = random.between(-size, size) * kFrameCell;
  for (int i = 0; i < 3; ++i) {
    const double along = length == 0 ? 0 : parts[i] / length;
    move.axis[i] = static_cast<int32_t>(std::lround(along * kRotationOne));
    const int32_t cells = random.between(-far, far);
    move.point[i] = cells * kFrameCell + random.between(0, kFrameCell);
    move.travel[i] = is_screw               ? static_cast<int32_t>(along * pitch)
                     : random.below(2) == 0 ? random.between(-size * kFrameCell, size * kFrameCell)
                                            : 0;
  }
  return move;
}

inline Pose any_end(Random& random, const MotionScene& scene) {
  const Pose pose = any_rigid_pose(random, 4 * scene.size);
  return random.below(3) == 0 ? with_five_decimals(pose) : pose;
}

/// A motion at some moment of which two corners meet, or nearly so.
inline AnyMotion any_motion(Random& random, const MotionScene& scene) {
  AnyMotion any;
  if (random.below(4) == 0) {
    const BodyMotion straight = any_translation(random, scene).motion();
    any.from = straight.from();
    any.to = straight.to();
    return any;
  }
  any.from = any_end(random, scene);
  any.to = any_end(random, scene);
  const uint32_t kind = random.below(6);
  if (kind == 1) {  // by half a turn about an axis
    const int32_t half[3][3] = {{kRotationOne, 0, 0}, {0, -kRotationOne, 0}, {0, 0, -kRotationOne}};
    any.to = Pose::composed(any.from, Pose::rigid(half, {scene.size, 0, 0}));
  }
  const int32_t fars[] = {0, scene.size, 10 * scene.size, 1000, 50'000};
  const uint32_t most = random.below(16) == 0 ? 20 : 4;
  for (uint32_t i = kind > 1 ? 1 + random.below(most) : 0; i-- > 0;) {
    any.moves.push_back(any_move(random, random.one_of(fars), scene.size));
  }
  const BodyMotion motion = any.motion();
  const double time = random.below(9) / 8.0;
  const FloatVector at =
      ExactMotion(motion).at(time, vector_of<double>(scene.b.any_corner(random)));
  const FloatVector off = minus(vector_of<double>(scene.a.any_corner(random)), at);
  const int32_t beside = random.below(3) == 0 ? 3 * scene.size : 1;
  any.shift(sum(
      any_point(random, beside),
      {static_cast<int32_t>(off[0]), static_cast<int32_t>(off[1]), static_cast<int32_t>(off[2])}));
  return any;
}

/// Two bodies, a motion, and the distance that they keep.
struct Encounter {
  explicit Encounter(Random& random)
      : scene(MotionScene::any(random)),
        any(any_motion(random, scene)),
        motion(any.motion()),
        a(scene.a.baked.view()),
        b(scene.b.baked.view()),
        within(random.below(2) * random.below(3000)) {}
  Encounter(const Encounter&) = delete;

  FirstContact query() const { return {a, b, motion, {within}}; }
  bool is_in_range() const { return query().status() == Status::suspended; }

  MotionScene scene;
  AnyMotion any;
  BodyMotion motion;
  Mesh a;
  Mesh b;
  std::uint32_t within;
};

}  // namespace flashbvh::test
