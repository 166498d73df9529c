// The last stage: firmware's robot, in fixed point, with its links' trees and its tables.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/baked/bake_links.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/pipeline/divide.hpp"

namespace flashbvh::tool {

/// A guard may stop two simplified links earlier by this many deviations: two for the meshes and
/// two for the slack.
constexpr double kEarlyByDeviation = 4;

/// Its members point into each other; moving the object is safe.
struct BakedRobot : Divided {
  std::vector<BakedLink> links;  ///< firmware's trees, in the order of the model's links
  double simplified = 0;         ///< allowed deviation of firmware's links in metres; 0: none
  std::uint32_t leaf_size = 0;   ///< of firmware's links
  std::size_t own_bytes = 0;     ///< size of the image without meshes
  std::unique_ptr<FixedRobot> fixed;

  const Robot& robot() const { return fixed->robot(); }
};

/// All stages after reading. UserError if the robot cannot be baked.
BakedRobot baked_robot(Model model, const RobotRequest& request, const Told& told,
                       Warnings& warnings);

/// The robot's image, with this name.
std::vector<std::uint32_t> image_of(const BakedRobot& robot, const std::string& name);

}  // namespace flashbvh::tool
