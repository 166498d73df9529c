// Levers bound how far joints move a link at its current place; a reach is the lever of the most
// stretched arm.
//
// A certificate stores each lever as a share of its joint's reach. A point moves away from an axis
// by at most what the joints move it, so levers grow by the joints' motion since then.
//
// Source: lib/docs/derivations.md, "Levers".
#pragma once

#include <stdint.h>

#include "branch.hpp"
#include "flashbvh/robot/robot.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {

/// The share of a whole reach.
constexpr uint8_t kWholeReach = 255;

/// Upper bound on the lever from which the share was made.
constexpr uint32_t lever_of(uint32_t reach, uint8_t share) {
  return reach - (reach >> 8) * (kWholeReach - share);
}

/// Sets the shares of the reaches of all joints between two links, at `frames`; kWholeReach if the
/// joint does not turn.
void set_shares(const Robot& robot, const RobotPair& pair, const Frame* frames, uint8_t* shares);

/// Sum of the motions of a pair's joints, which began or ended where the shares hold. No joint's
/// motion is above 2^31.
class LeverTravel {
 public:
  void add(const RobotJoint& joint, uint32_t reach, uint8_t share, uint32_t by) {
    by_reaches_.add_short(reach, by);
    by_levers_.add_short(lever_of(reach, share), by);
    turned_ += turns(joint) ? by : 0;
  }
  /// The links' motion in 1/256 cell, rounded up: by levers, or by reaches if that is less.
  uint32_t fine() const { return fine(by_reaches_.fine()); }
  /// fine() of joints that neither began nor ended where the shares hold, but got no farther from
  /// there than the links' motion `since`.
  uint32_t fine(uint32_t since) const;

 private:
  static bool turns(const RobotJoint& joint) {
    return joint.type == JointType::revolute || joint.type == JointType::continuous;
  }

  Travel by_reaches_;
  Travel by_levers_;
  uint64_t turned_ = 0;
};

}  // namespace flashbvh::detail
