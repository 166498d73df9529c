// How far joints move a link where it stands: a reach is that of the most stretched arm.
//
// A share of the joint's reach, its lever, is kept with a certificate. While joints move on, a
// point goes away from an axis by at most what they move it, so levers grow by that.
//
// Source: lib/docs/derivations.md, "Levers".
#ifndef FLASHBVH_ROBOT_LEVERS_HPP
#define FLASHBVH_ROBOT_LEVERS_HPP

#include <stdint.h>

#include "branch.hpp"
#include "flashbvh/robot/robot.hpp"

namespace flashbvh::detail {

/// The share that stands for all of a reach.
constexpr uint8_t kWholeReach = 255;

/// At least the lever that the share was made of.
constexpr uint32_t lever_of(uint32_t reach, uint8_t share) {
  return reach - (reach >> 8) * (kWholeReach - share);
}

/// Of the reaches of all joints between the links, where frames are: `shares` has one for each. All
/// of it where the joint doesn't turn.
void set_shares(const Robot& robot, const RobotPair& pair, const Frame* frames, uint8_t* shares);

/// The ways of all joints between two links, which began or ended where the shares hold. Of a
/// pair's joints: no way is more than 2^31.
class LeverTravel {
 public:
  void add(const RobotJoint& joint, uint32_t reach, uint8_t share, uint32_t by) {
    by_reaches_.add_short(reach, by);
    by_levers_.add_short(lever_of(reach, share), by);
    turned_ += turns(joint) ? by : 0;
  }
  /// In 1/256 cell, rounded up: by levers, or by reaches if that is less.
  uint32_t fine() const;

 private:
  static bool turns(const RobotJoint& joint) {
    return joint.type == JointType::revolute || joint.type == JointType::continuous;
  }

  Travel by_reaches_;
  Travel by_levers_;
  uint64_t turned_ = 0;
};

}  // namespace flashbvh::detail

#endif
