// Adds bodies to a robot at run time: tools mounted on it, and obstacles that stand in the base's
// frame or that the caller moves.
//
// A workcell is a robot in RAM: a copy of the baked robot's arrays, to which bodies and pairs are
// added. Guards and motion queries take it like a baked robot; added bodies are its links. To
// change tools, make the workcell again and prime the guard.
//
// The guarantee for a tool is that for a link. A tool's reaches come from its bounding sphere,
// swept over all joint values. So guards measure a long thin tool more often than a baked link of
// its shape. Guards check tools and obstacles unrounded, as in their source. The guarantee for an
// obstacle depends on the path length that the caller states.
//
// Stack of its functions on Cortex-M3 to M55 at -O2: 400 bytes at most.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// All memory of a workcell, including the robot's own parts. Each body takes a joint, a link and a
/// reach for each joint between it and the base; each guarded pair takes a pair.
template <uint32_t joint_count, uint32_t link_count, uint32_t pair_count, uint32_t reach_count>
struct alignas(8) WorkcellOf {
  RobotJoint joints[joint_count];
  RobotLink links[link_count];
  Mesh meshes[link_count];
  RobotPair pairs[pair_count];
  uint32_t reaches[reach_count];
};

/// The workcell of one robot. It is not copied, since its robot() is a view of `memory`.
class Workcell {
 public:
  using Room = flashbvh_workcell_room;

  /// Starts with the robot only. The robot's meshes must outlive the workcell. `memory` is written
  /// and must outlive it.
  template <uint32_t joint_count, uint32_t link_count, uint32_t pair_count, uint32_t reach_count>
  Workcell(const Robot& robot, WorkcellOf<joint_count, link_count, pair_count, reach_count>& memory)
      : robot_(robot),
        joints_(memory.joints),
        links_(memory.links),
        meshes_(memory.meshes),
        pairs_(memory.pairs),
        reaches_(memory.reaches),
        room_{joint_count, link_count, pair_count, reach_count},
        own_joints_(robot.joint_count) {
    copy();
  }
  /// Takes `size` bytes instead, with the layout of a WorkcellOf with the counts of `room`.
  Workcell(const Robot& robot, void* memory, size_t size, const Room& room)
      : robot_(robot),
        joints_(static_cast<RobotJoint*>(memory)),
        links_(reinterpret_cast<RobotLink*>(joints_ + room.joints)),
        meshes_(reinterpret_cast<Mesh*>(links_ + room.links)),
        pairs_(reinterpret_cast<RobotPair*>(meshes_ + room.links)),
        reaches_(reinterpret_cast<uint32_t*>(pairs_ + room.pairs)),
        room_(room),
        own_joints_(robot.joint_count) {
    const uint64_t needed = uint64_t{room.joints} * sizeof(RobotJoint) +
                            uint64_t{room.links} * (sizeof(RobotLink) + sizeof(Mesh)) +
                            uint64_t{room.pairs} * sizeof(RobotPair) +
                            uint64_t{room.reaches} * sizeof(uint32_t);
    if (reinterpret_cast<uintptr_t>(memory) % alignof(Mesh) != 0 || needed > size) {
      room_ = {0, 0, 0, 0};
    }
    copy();
  }
  Workcell(const Workcell&) = delete;
  Workcell& operator=(const Workcell&) = delete;

  /// True if the robot is open and the memory is large enough for it.
  bool fits() const { return room_.links != 0; }
  /// Returns `done`; `not_open`: the robot is not; `workcell_full`: the memory is too small for it.
  Status status() const {
    return !detail::is_open(robot_) ? Status::not_open
           : fits()                 ? Status::done
                                    : Status::workcell_full;
  }

  /// Returns the robot with all added bodies; make guards of it after adding.
  const Robot& robot() const { return robot_; }

  /// Adds a tool on a joint, or an obstacle in the base's frame (kBase); `link` gets its number.
  /// Its mesh is in the mount's frame. `workcell_full`: the memory has no capacity left, or not
  /// even for the robot; `not_open`: the mesh or the robot; `cell_mismatch`: the mesh's cell
  /// differs from the links'; `link_invalid`: there is no such joint; `not_a_rotation`;
  /// `translation_out_of_range`: it may come 2^19 cells or more from a joint of its branch;
  /// `distance_out_of_range`: the mesh deviates from its source by too much, or by an unknown
  /// length. The mesh must not change afterwards, as one that bends does. Time is linear in all
  /// vertices and triangles, for the sphere and the hash.
  Status add(const Mesh& mesh, const Mount& mount, uint8_t& link);

  /// Makes guards keep two links apart. `warn`: at least `stop`. `workcell_full`; `not_open`;
  /// `link_invalid`: there are no two such links, or no joint between them;
  /// `distance_out_of_range`: `warn` is beyond kMaxGuardDistance or below `stop`, or the joints
  /// move the two too far for a guard's sums.
  Status keep_apart(uint8_t a, uint8_t b, FineLength stop, FineLength warn);

  /// Moves an obstacle to a frame, from the next period on, which begins with Guard::update().
  /// `moved`: upper bound of each point's path length; a rejected period's motion
  /// counts in the next one. A guard rejects periods, `joint_jumped`, once an obstacle has moved by
  /// 2^31 since the last accepted one: prime it. It may do so once all obstacles together have
  /// moved by 2^30. Their count wraps at 2^48. Do not call it between update() and go_on(), nor
  /// while a MotionQuery runs: their results assume that obstacles stand still. `not_open`;
  /// `link_invalid`: it is no added obstacle; `distance_out_of_range`: `moved` is 2^28 or more;
  /// `not_a_rotation` and `translation_out_of_range` as in add(). It then stays where it was.
  Status move(uint8_t link, const Frame& frame, FineLength moved);

 private:
  void copy();
  bool sweep(const RobotLink& body, uint32_t* reaches, uint32_t& error) const;
  uint32_t rounding_with(const Mesh& mesh) const;
  uint32_t slack_with(const RobotLink& body, const Mesh& mesh, uint32_t error) const;
  uint32_t joints_on_branch(uint8_t joint) const;
  uint64_t branch_of(const RobotLink& link) const;
  uint8_t joints_beside(const RobotLink& link, uint64_t other, uint64_t& sum) const;

  Robot robot_;
  RobotJoint* joints_;
  RobotLink* links_;
  Mesh* meshes_;
  RobotPair* pairs_;
  uint32_t* reaches_;
  Room room_;
  uint8_t own_joints_;  ///< joints of the baked robot
};

}  // namespace flashbvh
