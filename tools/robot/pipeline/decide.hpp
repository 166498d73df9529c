// The stage that decides: which pairs of links can collide, and where links may touch.
#pragma once

#include <set>
#include <vector>

#include "robot/matrix/joint_zone.hpp"
#include "robot/matrix/matrix.hpp"
#include "robot/pipeline/prepare.hpp"

namespace flashbvh::tool {

/// The verdicts on a prepared robot.
struct Decided {
  Reaches reaches;        ///< of the links
  MatrixOptions options;  ///< used to decide pairs; includes the deadline for parts of links
  std::vector<JointZone> zones;
  std::set<std::size_t> late_joints;  ///< without a zone when its time was up
  std::vector<PairVerdict> pairs;
};

/// Takes some seconds per pair if proofs are hard. `early`: how much earlier than requested a guard
/// may stop, in metres. Warns of joints whose search for a zone ran out of time; `late`: the
/// consequence for their links. UserError if a guard can't hold the robot.
Decided decide(const Prepared& robot, const RobotRequest& request, double early,
               const std::string& late, const Told& told, Warnings& warnings);

}  // namespace flashbvh::tool
