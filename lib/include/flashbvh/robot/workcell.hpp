// What is added to a robot at run time: tools mounted on it, obstacles that stand in the base's
// frame or that the caller moves.
//
// A workcell is a robot in RAM: a copy of the baked one's arrays, to which bodies and pairs are
// added. Guards and motion queries take it as they take the baked one; what is mounted is one of
// its links. To change tools, make the workcell again and prime the guard.
//
// What is promised of a tool is what is promised of a link: how far each joint moves it is bounded
// by the sphere round it, swept over all settings of the joints, so a long thin tool is measured
// more often than a baked link of its shape would be. Tools and obstacles are guarded as they were
// drawn, before baking rounded their vertices. What is promised of an obstacle hangs on what
// the caller says of its way.
//
// Stack of its functions on Cortex-M3 to M55 at -O2: 400 bytes at most.
#ifndef FLASHBVH_ROBOT_WORKCELL_HPP
#define FLASHBVH_ROBOT_WORKCELL_HPP

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/robot/robot.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// All memory of a workcell. At least as many of each as the robot has; each body takes a joint, a
/// link and, on its way to the base, a reach for each joint; each pair that is to be guarded a
/// pair.
template <uint32_t joint_count, uint32_t link_count, uint32_t pair_count, uint32_t reach_count>
struct alignas(8) WorkcellOf {
  RobotJoint joints[joint_count];
  RobotLink links[link_count];
  Mesh meshes[link_count];
  RobotPair pairs[pair_count];
  uint32_t reaches[reach_count];
};

/// Of one robot; not copied, as its robot() is a view of `memory`.
class Workcell {
 public:
  using Room = flashbvh_workcell_room;

  /// The robot alone. Its meshes outlive the workcell; `memory` is written, and outlives it.
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
  /// The same in `size` bytes, as a WorkcellOf of `room` lies in them.
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

  /// Whether the memory is enough for the robot.
  bool fits() const { return room_.links != 0; }

  /// With all that was added; a guard is made of it afterwards.
  const Robot& robot() const { return robot_; }

  /// A tool that hangs on a joint, or an obstacle that stands in the base's frame (kBase); `link`
  /// is its number. Its mesh lies in the mount's frame. `workcell_full`: the memory holds no more,
  /// or not even the robot; `cell_mismatch`: the mesh was baked with another cell than the links;
  /// `link_invalid`: there is no such joint; `not_a_rotation`; `translation_out_of_range`: it may
  /// come 2^19 cells from a joint of its branch or more.
  /// Takes time linear in vertices and triangles: all are looked at, for the sphere and the hash.
  Status add(const Mesh& mesh, const Mount& mount, uint8_t& link);

  /// That two links are to be kept apart: distances in 1/256 cell, `warn` at least `stop`.
  /// `workcell_full`; `link_invalid`: there are no two such links, or no joint between them;
  /// `distance_out_of_range`: `warn` is beyond kMaxGuardDistance or below `stop`, or the joints
  /// move the two too far for a guard's sums.
  Status keep_apart(uint8_t a, uint8_t b, uint32_t stop, uint32_t warn);

  /// The obstacle is in that frame from the next period on, which begins with Guard::update().
  /// `moved`: no point's way there is longer, in 1/256 cell. What was moved for a
  /// period that is refused counts in the next one.
  /// Not between update() and go_on(), nor while a MotionQuery is under way: what they answer holds
  /// for an obstacle that stands meanwhile.
  /// `link_invalid`: it is no obstacle that was added; `distance_out_of_range`: `moved` is 2^28 or
  /// more; `not_a_rotation` and `translation_out_of_range` as of add(). It then stays where it was.
  Status move(uint8_t link, const Frame& frame, uint32_t moved);

 private:
  void copy();
  bool sweep(const RobotLink& body, uint32_t* reaches, uint32_t& error) const;
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
  uint8_t own_joints_;  ///< the robot's
};

}  // namespace flashbvh

#endif
