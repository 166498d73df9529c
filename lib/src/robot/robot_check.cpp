// Checks that a robot's numbers keep kinematics, guard and motions within arrays and ranges, and
// that their loops terminate. Each number is read after all numbers on which it relies are checked.
#include "../lattice/vertex_rounding.hpp"
#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/robot/distance_table.hpp"
#include "flashbvh/detail/robot/image_parts.hpp"
#include "spheres.hpp"

namespace flashbvh::detail {
namespace {

/// Largest distance of a robot's points from the base, in 1/2,048 cell, by lengths rounded up. With
/// the rounding of 64 joints, 2^11, differences of two places fit 32 bits.
constexpr uint32_t kMostExtent = kMaxFrameTranslation - (1 << 15);

/// Each entry is off by half of 2^-30, so a product of two unit rows is off by 1.74 * 2^-30.
constexpr int64_t kRotationRounding = 2 * int64_t{kRotationOne};

/// Slack for rounding placed vertices, in 1/256 cell (lib/docs/derivations.md, "Robots"), less what
/// rounding up two deviations adds.
constexpr uint32_t kPlacingSlack = kVertexRounding - 2;

constexpr uint8_t kMostShift = 40;
constexpr int32_t kMostMultiplier = 1 << 30;

/// Reach of a prismatic joint, by definition.
constexpr uint32_t kSlidingReach = uint32_t{256} << (kReachBits - kFrameBits);

constexpr bool is_within(int32_t value, int32_t most) {
  return value >= -most && value <= most;
}

/// Length of a vector in 1/2,048 cell, rounded down, plus 1.
uint32_t length_above(const int32_t (&v)[3]) {
  uint64_t square = 0;
  for (const int32_t at : v) {
    square += uint64_t{magnitude(at)} * magnitude(at);
  }
  return square_root(square) + 1;
}

int64_t dot(const int32_t (&u)[3], const int32_t (&v)[3]) {
  return int64_t{u[0]} * v[0] + int64_t{u[1]} * v[1] + int64_t{u[2]} * v[2];
}

/// The determinant; its sign shows whether an orthogonal matrix mirrors.
int64_t determinant(const int32_t (&r)[3][3]) {
  int64_t sum = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    const int k = i == 0 ? 2 : i - 1;
    const int64_t cofactor = int64_t{r[1][j]} * r[2][k] - int64_t{r[1][k]} * r[2][j];
    sum += (cofactor >> 30) * r[0][i];
  }
  return sum;
}

/// Tests for a rotation, within the rounding of its entries.
[[gnu::noinline]] bool is_rotation(const int32_t (&r)[3][3]) {
  for (const auto& row : r) {
    if (!is_within(row[0], kRotationOne) || !is_within(row[1], kRotationOne) ||
        !is_within(row[2], kRotationOne)) {
      return false;
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      const int64_t off = dot(r[i], r[j]) - (i == j ? int64_t{kRotationOne} * kRotationOne : 0);
      if (off < -kRotationRounding || off > kRotationRounding) {
        return false;
      }
    }
  }
  return determinant(r) > 0;
}

bool has_limits(const RobotJoint& joint) {
  switch (joint.type) {
    case JointType::continuous:
      return joint.lower == 0 && joint.upper == 0;
    case JointType::revolute:
    case JointType::prismatic:
      return joint.lower >= -kMaxJointCoordinate && joint.lower <= joint.upper &&
             joint.upper <= kMaxJointCoordinate;
    default:
      return false;
  }
}

bool has_factor(const RobotJoint& joint) {
  return joint.shift == 0
             ? joint.multiplier == 1 && joint.offset == 0
             : joint.shift <= kMostShift && is_within(joint.multiplier, kMostMultiplier) &&
                   is_within(joint.offset, kMaxJointCoordinate);
}

/// A mimic of a joint without limits has no limits, and its multiplier is a whole number.
bool follows(const RobotJoint& joint, const RobotJoint& master) {
  const bool is_free = joint.type == JointType::continuous;
  const uint64_t parts = static_cast<uint64_t>(int64_t{joint.multiplier});
  return is_free == (master.type == JointType::continuous) &&
         (!is_free || (parts & ((uint64_t{1} << joint.shift) - 1)) == 0);
}

/// Checks that each variable has exactly one joint that is no mimic.
[[gnu::noinline]] bool check_variables(const Robot& robot) {
  uint8_t masters[kMaxJoints];
  uint64_t seen = 0;
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if (joint.variable >= robot.variable_count) {
      return false;
    }
    const uint64_t variable = uint64_t{1} << joint.variable;
    if (joint.shift == 0) {
      if ((seen & variable) != 0) {
        return false;
      }
      seen |= variable;
      masters[joint.variable] = static_cast<uint8_t>(i);
    }
  }
  const uint32_t spare = 64u - robot.variable_count;
  if (seen != (spare == 64 ? 0 : ~uint64_t{0} >> spare)) {
    return false;
  }
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    if (!follows(robot.joints[i], robot.joints[masters[robot.joints[i].variable]])) {
      return false;
    }
  }
  return true;
}

/// Largest distance of the joint's frame from the base.
uint64_t extent_of(const RobotJoint& joint, const uint32_t* extents) {
  const bool slides = joint.type == JointType::prismatic;
  return uint64_t{length_above(joint.fixed.translation)} +
         (slides ? greater(magnitude(joint.lower), magnitude(joint.upper)) : 0) +
         (joint.parent == kBase ? 0 : extents[joint.parent]);
}

bool check_joints(const Robot& robot, uint32_t* extents) {
  for (uint32_t i = 0; i < robot.joint_count; ++i) {
    const RobotJoint& joint = robot.joints[i];
    if ((joint.parent >= i && joint.parent != kBase) || !has_limits(joint) || !has_factor(joint) ||
        joint.laps != 0 || !is_rotation(joint.fixed.rotation)) {
      return false;
    }
    const uint64_t extent = extent_of(joint, extents);
    if (extent > kMostExtent) {
      return false;
    }
    extents[i] = static_cast<uint32_t>(extent);
  }
  return true;
}

bool check_link(const Robot& robot, const RobotLink& link, const uint32_t* extents) {
  if (link.padding != 0 || (link.joint >= robot.joint_count && link.joint != kBase) ||
      link.deviation > kMaxGuardDistance || robot.slack < kPlacingSlack + 2 * link.deviation) {
    return false;
  }
  const uint64_t extent = uint64_t{length_above(link.centre)} + link.radius +
                          (link.joint == kBase ? 0 : extents[link.joint]);
  return extent <= kMostExtent;
}

/// Checks all links, and that reaches are stored link by link, without others.
bool check_links(const Robot& robot, const uint32_t* extents) {
  uint32_t reach = 0;
  for (uint32_t i = 0; i < robot.link_count; ++i) {
    const RobotLink& link = robot.links[i];
    if (!check_link(robot, link, extents) || link.first_reach != reach) {
      return false;
    }
    for (uint32_t j = link.joint; j != kBase; j = robot.joints[j].parent, ++reach) {
      const bool slides = reach < robot.reach_count && robot.joints[j].type == JointType::prismatic;
      if (reach >= robot.reach_count || (slides && robot.reaches[reach] != kSlidingReach)) {
        return false;
      }
    }
  }
  return reach == robot.reach_count;
}

/// Checks a pair's joints, those on one of the two branches only. Of two joints the one with the
/// greater number is not an ancestor of the other.
bool check_between(const Robot& robot, const RobotPair& pair) {
  const RobotLink* const links[2] = {&robot.links[pair.a], &robot.links[pair.b]};
  uint32_t joints[2] = {links[0]->joint, links[1]->joint};
  uint32_t counts[2] = {0, 0};
  uint64_t reach = 0;
  while (joints[0] != joints[1]) {
    const int of = joints[1] == kBase || (joints[0] != kBase && joints[0] > joints[1]) ? 0 : 1;
    reach += robot.reaches[links[of]->first_reach + counts[of]++];
    joints[of] = robot.joints[joints[of]].parent;
  }
  return pair.joints_a == counts[0] && pair.joints_b == counts[1] && pair.reach == reach;
}

/// Checks that pairs ascend, so that no two links are paired twice.
[[gnu::noinline]] bool check_pairs(const Robot& robot, uint32_t& joints_between) {
  uint32_t next = 0;
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    const uint32_t place = uint32_t{pair.a} << 8 | pair.b;
    if (pair.a >= pair.b || pair.b >= robot.link_count || place < next || pair.stop > pair.warn ||
        pair.warn > kMaxGuardDistance || !check_between(robot, pair)) {
      return false;
    }
    joints_between += pair.joints_a + pair.joints_b;
    next = place + 1;
  }
  return true;
}

/// Checks that all pairs that can have a distance table have one, or none has.
bool check_distance_tables(const Robot& robot) {
  uint32_t bytes = 0;
  for (uint32_t i = 0; i < robot.pair_count; ++i) {
    bytes += distance_table_size(robot, robot.pairs[i]);
  }
  return robot.distance_table_bytes == 0 || robot.distance_table_bytes == bytes;
}

[[gnu::noinline]] bool check_tree(const Robot& robot) {
  uint32_t extents[kMaxJoints];
  return check_joints(robot, extents) && check_variables(robot) && check_links(robot, extents);
}

bool holds(const RobotLink& link, const int32_t (&origin)[3], const Vertex& vertex) {
  const int32_t coordinates[3] = {vertex.x, vertex.y, vertex.z};
  uint64_t square = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int64_t at = (int64_t{origin[axis]} + coordinates[axis]) * kFrameCell;
    const int64_t apart = at - link.centre[axis];
    const auto size = static_cast<uint64_t>(apart < 0 ? -apart : apart);
    if (size > link.radius) {
      return false;
    }
    square += size * size;
  }
  return square <= uint64_t{link.radius} * link.radius;
}

}  // namespace

bool check_robot(const Robot& robot, uint32_t& pair_joint_count) {
  pair_joint_count = 0;
  return check_tree(robot) && check_pairs(robot, pair_joint_count) && check_distance_tables(robot);
}

bool check_spheres(const Robot& robot) {
  for (uint32_t i = 0; i < robot.link_count; ++i) {
    const Mesh& mesh = robot.meshes[i];
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
      if (!holds(robot.links[i], mesh.origin, mesh.vertices[v])) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace flashbvh::detail
