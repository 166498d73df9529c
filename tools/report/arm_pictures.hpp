// A robot in a configuration, as pictures.
#ifndef FLASHBVH_TOOLS_REPORT_ARM_PICTURES_HPP
#define FLASHBVH_TOOLS_REPORT_ARM_PICTURES_HPP

#include <string>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "flashbvh/step.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// All outlives the drawing.
struct PosedArm {
  const Model& model;
  const Robot& robot;
  std::vector<Pose> poses;  ///< of each link in the base's frame
};

/// Of the robot's links, in metres.
double cell_of(const Robot& robot);

/// Two of its links, and a triangle of each by its id.
struct LitPair {
  std::size_t a;
  std::size_t b;
  TrianglePair<std::uint16_t> triangles;
  const char* what;  ///< that they are: "the triangles that are nearest"
};

/// All links, and the two from near, their triangles lit; below it where these are nearest: HTML.
std::string pair_pictures(const PosedArm& arm, const LitPair& pair);

/// Whole arms in one frame, their links in colours that take turns; a caption each, HTML.
std::string arm_pictures(const std::vector<PosedArm>& arms,
                         const std::vector<std::string>& captions);

/// "upper - fore", HTML.
std::string links_of(const Model& model, std::size_t a, std::size_t b);

/// "elbow 1.5, wrist 0", HTML. A value a variable.
std::string joint_values(const Model& model, const std::vector<double>& values);

/// What the pictures' marks need.
std::string arm_style();

}  // namespace flashbvh::tool

#endif
