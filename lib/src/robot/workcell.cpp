// A robot's arrays in RAM, to which bodies and pairs are added.
#include "flashbvh/robot/workcell.hpp"

#include "../lattice/vertex_rounding.hpp"
#include "branch.hpp"
#include "coordinate.hpp"
#include "flashbvh/clearance.hpp"
#include "hash.hpp"
#include "spheres.hpp"

namespace flashbvh {

using detail::has_cell;
using detail::is_open;

namespace {

/// Reach of the joint that counts how far an obstacle moved, in 1/256 cell. A tool's joint never
/// counts.
constexpr uint32_t kOneForOne = 1u << kReachBits;
constexpr uint32_t kMostMoved = 1u << 28;

/// Limit of distances from the base and from each joint, in 1/2,048 cell, as for baked links.
constexpr uint64_t kFarthestFrame = kMaxFrameTranslation - (1 << 16);

/// Square of a length of up to 2^31.
uint64_t square(int64_t value) {
  return static_cast<uint64_t>(value * value);
}

bool is_rotation(const Frame& frame) {
  constexpr int32_t nowhere[3] = {0, 0, 0};
  return Pose::rigid(frame.rotation, nowhere).status() == Status::done;
}

/// Largest distance of a point of the sphere from its frame's z axis.
uint32_t lever_of(const RobotLink& link) {
  return detail::square_root(square(link.centre[0]) + square(link.centre[1])) + 1 + link.radius;
}

/// Sets a link's sphere. False if the sphere gets too far from the frame's origin.
bool set_sphere(const int64_t (&centre)[3], uint64_t radius, RobotLink& link) {
  uint64_t squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (centre[axis] < -kMaxFrameTranslation || centre[axis] > kMaxFrameTranslation) {
      return false;
    }
    squared += square(centre[axis]);
    link.centre[axis] = static_cast<int32_t>(centre[axis]);
  }
  link.radius = static_cast<uint32_t>(radius);
  return detail::square_root(squared) + radius < kFarthestFrame;
}

/// set_sphere() with a sphere round the mesh. The sphere is slightly larger than the mesh, since a
/// frame's matrix may differ from a rotation by kRotationTolerance.
bool set_sphere_round(const Mesh& mesh, RobotLink& link) {
  int32_t low[3] = {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate};
  int32_t high[3] = {-kMaxCoordinate, -kMaxCoordinate, -kMaxCoordinate};
  const auto each_vertex = [&](auto&& visit) {
    for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
      const Vertex& v = mesh.vertices[i];
      const int32_t at[3] = {v.x, v.y, v.z};
      visit(at);
    }
  };
  each_vertex([&](const int32_t(&at)[3]) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
      high[axis] = at[axis] > high[axis] ? at[axis] : high[axis];
    }
  });
  uint64_t most = 0;  // in square halves of a cell
  each_vertex([&](const int32_t(&at)[3]) {
    uint64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      sum += square(2 * at[axis] - low[axis] - high[axis]);
    }
    most = sum > most ? sum : most;
  });
  int64_t centre[3];
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = (2 * int64_t{mesh.origin[axis]} + low[axis] + high[axis]) * (kFrameCell / 2);
  }
  const uint32_t radius = (detail::square_root(most) + 1) * (kFrameCell / 2);
  return set_sphere(centre, radius + (radius >> 12) + 1, link);
}

/// Largest motion of the sphere per unit of the joint's coordinate, in 2^-kReachBits of 1/256 cell.
uint32_t reach_of(const RobotJoint& joint, const RobotLink& link) {
  switch (joint.type) {
    case JointType::prismatic:
      return 1u << (kReachBits - kFrameBits + 8);
    case JointType::fixed:
      return joint.parent == kBase ? kOneForOne : 0;
    default:
      break;
  }
  return detail::reach_at(lever_of(link));
}

/// set_sphere() with a sphere round the volume that the link's sphere sweeps at all coordinates of
/// the joint, in the parent's frame.
bool sweep_over(const RobotJoint& joint, RobotLink& link) {
  int64_t centre[3] = {link.centre[0], link.centre[1], link.centre[2]};
  uint64_t radius = link.radius;
  if (joint.type == JointType::prismatic) {
    centre[2] += (int64_t{joint.lower} + joint.upper) / 2;
    radius += static_cast<uint64_t>(int64_t{joint.upper} - joint.lower) / 2 + 1;
  } else if (joint.type != JointType::fixed) {
    radius = lever_of(link);
    centre[0] = centre[1] = 0;
  }
  if (!set_sphere(centre, radius, link)) {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis] = detail::centre_of(link, joint.fixed, axis);
  }
  return set_sphere(centre, radius + 1, link);
}

}  // namespace

void Workcell::copy() {
  if (!is_open(robot_) || room_.joints < robot_.joint_count || room_.links < robot_.link_count ||
      room_.pairs < robot_.pair_count || room_.reaches < robot_.reach_count) {
    room_ = {0, 0, 0, 0};
    return;
  }
  const auto take = [](auto*& from, auto* to, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      to[i] = from[i];
    }
    from = to;
  };
  take(robot_.joints, joints_, robot_.joint_count);
  take(robot_.links, links_, robot_.link_count);
  take(robot_.meshes, meshes_, robot_.link_count);
  take(robot_.pairs, pairs_, robot_.pair_count);
  take(robot_.reaches, reaches_, robot_.reach_count);
}

/// Follows the branch to the base with the sphere round the link's swept volume. Sets a reach for
/// each joint, unless `reaches` is null, and the error of arithmetic in 1/65,536 cell
/// (lib/docs/derivations.md, "Robots"). False if the link may get too far from a joint.
bool Workcell::sweep(const RobotLink& body, uint32_t* reaches, uint32_t& error) const {
  RobotLink link = body;
  constexpr uint32_t rounding = 58;  // of a translation, twice, by half of 1/2,048 along each axis
  constexpr uint32_t turned = kFarthestFrame >> 22;  // by 2^-27 at the largest distance
  error = 34;                                        // of the relative pose
  for (uint8_t j = link.joint; j != kBase; j = joints_[j].parent) {
    const RobotJoint& joint = joints_[j];
    const uint32_t reach = reach_of(joint, link);
    if (!sweep_over(joint, link)) {
      return false;
    }
    error += rounding + turned + (reach >> 16);
    if (reaches != nullptr) {
      *reaches++ = reach;
    }
  }
  return true;
}

uint32_t Workcell::joints_on_branch(uint8_t joint) const {
  uint32_t count = 0;
  for (; joint != kBase; joint = joints_[joint].parent) {
    ++count;
  }
  return count;
}

/// The rounding of placed vertices, of this mesh and all others, in 1/65,536 cell.
uint32_t Workcell::rounding_with(const Mesh& mesh) const {
  uint64_t most = 0;
  const Mesh* of = &mesh;
  for (uint32_t i = 0; of != nullptr; ++i) {
    const uint64_t sum = uint64_t{detail::magnitude(of->origin[0])} +
                         detail::magnitude(of->origin[1]) + detail::magnitude(of->origin[2]);
    most = sum > most ? sum : most;
    of = i < robot_.link_count ? &robot_.meshes[i] : nullptr;
  }
  return detail::vertex_rounding(most);
}

/// The slack of the robot with one more body. `error`: of sweep().
uint32_t Workcell::slack_with(const RobotLink& body, const Mesh& mesh, uint32_t error) const {
  const uint32_t rounding = rounding_with(mesh);
  const uint32_t deviation = detail::largest_deviation(robot_);
  const uint32_t others = ((robot_.slack - 2 * deviation) << 8) - rounding_with(robot_.meshes[0]);
  const uint32_t kinematics = detail::greater(2 * error, others);
  // Its origin may lie farther than those of the others, which all of them may meet.
  return ((rounding + kinematics + 0xFF) >> 8) + 2 * detail::greater(body.deviation, deviation);
}

Status Workcell::add(const Mesh& mesh, const Mount& mount, uint8_t& link) {
  if (!is_open(robot_) || !has_cell(mesh)) {
    return Status::not_open;
  }
  const uint32_t joint = robot_.joint_count;
  if (mount.joint != kBase && mount.joint >= own_joints_) {
    return Status::link_invalid;
  }
  const uint32_t reaches = joints_on_branch(mount.joint) + 1;
  if (joint >= room_.joints || robot_.link_count >= room_.links || joint >= kMaxJoints ||
      robot_.link_count >= kMaxLinks || robot_.reach_count + reaches > room_.reaches) {
    return Status::workcell_full;
  }
  if (mesh.cell_bits != robot_.meshes[0].cell_bits) {
    return Status::cell_mismatch;
  }
  if (mesh.deviation_sixteenths == kDeviationUnknown) {
    return Status::distance_out_of_range;
  }
  if (!is_rotation(mount.frame)) {
    return Status::not_a_rotation;
  }
  RobotLink body{};
  body.joint = static_cast<uint8_t>(joint);
  body.first_reach = robot_.reach_count;
  body.deviation = mesh.deviation_sixteenths * 16u;
  RobotJoint& carrier = joints_[joint];
  carrier = {};
  carrier.fixed = mount.frame;
  carrier.parent = mount.joint;
  carrier.type = JointType::fixed;
  carrier.shift = 1;  // as a mimic's: no variable moves it
  carrier.lower = INT32_MIN;
  carrier.upper = INT32_MAX;
  uint32_t error = 0;
  // The first sweep, of a point, checks the frame.
  if (!sweep(body, nullptr, error) || !set_sphere_round(mesh, body) ||
      !sweep(body, reaches_ + robot_.reach_count, error)) {
    return Status::translation_out_of_range;
  }
  const uint32_t slack = slack_with(body, mesh, error);
  if (slack > kMaxGuardDistance) {
    return Status::distance_out_of_range;
  }
  robot_.slack = slack;
  link = robot_.link_count;
  links_[link] = body;
  meshes_[link] = mesh;
  ++robot_.joint_count;
  ++robot_.link_count;
  robot_.reach_count = static_cast<uint16_t>(robot_.reach_count + reaches);
  uint32_t hash = detail::hash_of(&carrier, 1, robot_.hash);
  hash = detail::hash_of(&robot_.links[link], 1, hash);
  hash = detail::hash_of(mesh.triangles, mesh.triangle_count, hash);
  robot_.hash = detail::hash_of(mesh.vertices, mesh.vertex_count, hash);
  return Status::done;
}

/// The joints of the link's branch, one bit each.
uint64_t Workcell::branch_of(const RobotLink& link) const {
  uint64_t branch = 0;
  for (uint8_t joint = link.joint; joint != kBase; joint = joints_[joint].parent) {
    branch |= uint64_t{1} << joint;
  }
  return branch;
}

/// Number of joints of the link's branch that are not on `other`; adds their reaches to `sum`.
uint8_t Workcell::joints_beside(const RobotLink& link, uint64_t other, uint64_t& sum) const {
  const uint32_t* reach = reaches_ + link.first_reach;
  uint8_t count = 0;
  for (uint8_t joint = link.joint; joint != kBase && (other >> joint & 1) == 0;
       joint = joints_[joint].parent) {
    sum += *reach++;
    ++count;
  }
  return count;
}

Status Workcell::keep_apart(uint8_t a, uint8_t b, FineLength stop, FineLength warn) {
  if (!is_open(robot_)) {
    return Status::not_open;
  }
  if (a >= robot_.link_count || b >= robot_.link_count) {
    return Status::link_invalid;
  }
  if (robot_.pair_count >= room_.pairs) {
    return Status::workcell_full;
  }
  const RobotLink& link_a = robot_.links[a];
  const RobotLink& link_b = robot_.links[b];
  uint64_t reach = 0;
  RobotPair pair{};
  pair.stop = stop.count;
  pair.warn = warn.count;
  pair.a = a;
  pair.b = b;
  pair.joints_a = joints_beside(link_a, branch_of(link_b), reach);
  pair.joints_b = joints_beside(link_b, branch_of(link_a), reach);
  pair.reach = static_cast<uint32_t>(reach);
  if (pair.joints_a + pair.joints_b == 0) {
    return Status::link_invalid;
  }
  if (pair.stop > pair.warn || pair.warn > kMaxGuardDistance || reach > UINT32_MAX) {
    return Status::distance_out_of_range;
  }
  pairs_[robot_.pair_count++] = pair;
  robot_.hash = detail::hash_of(&robot_.pairs[robot_.pair_count - 1], 1, robot_.hash);
  return Status::done;
}

Status Workcell::move(uint8_t link, const Frame& frame, FineLength moved) {
  if (!is_open(robot_)) {
    return Status::not_open;
  }
  const uint8_t number = link < robot_.link_count ? robot_.links[link].joint : kBase;
  if (number == kBase || number < own_joints_ || robot_.joints[number].parent != kBase) {
    return Status::link_invalid;
  }
  if (moved.count >= kMostMoved) {
    return Status::distance_out_of_range;
  }
  if (!is_rotation(frame)) {
    return Status::not_a_rotation;
  }
  RobotJoint& carrier = joints_[number];
  RobotJoint there = carrier;
  there.fixed = frame;
  RobotLink origin{};
  RobotLink body = robot_.links[link];
  if (!sweep_over(there, origin) || !sweep_over(there, body)) {
    return Status::translation_out_of_range;
  }
  carrier = there;
  detail::add_path(carrier, moved.count);
  return Status::done;
}

}  // namespace flashbvh
