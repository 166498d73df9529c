// What pages about robots share: pictures of configurations, names, verdicts.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "flashbvh/run_result.hpp"
#include "image/image_file.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

/// A dashed circle, in cells of the base's frame.
struct Ball {
  LatticePoint centre;
  std::int64_t radius;
};

/// As pairs are decided on it, or as firmware has it.
using ArmMesh = std::variant<WholeMesh, Mesh>;

/// All outlives the drawing.
struct PosedArm {
  const Model& model;
  double cell;                  ///< metres
  std::vector<ArmMesh> meshes;  ///< of each link
  std::vector<Pose> poses;      ///< of each link in the base's frame
  std::vector<Ball> balls = {};
};

/// Two of its links, and a triangle of each by its id.
struct LitPair {
  std::size_t a;
  std::size_t b;
  TrianglePair<WholeMesh::Index> triangles;
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

/// A verdict of a page: a square in the colour of a style class, the verdict, its subject; all
/// HTML.
std::string decision(const std::string& style, const std::string& what, const std::string& of);
/// A line a reason: "Not guarded: base - arm (neighbours that ...)". Nothing if there are none.
std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded);
/// The first section of a page.
std::string decision_section(const std::string& title, const std::string& decisions);
/// Behind the last section, with the version.
std::string footer();

}  // namespace flashbvh::tool
