#include "robot/baked/bake_links.hpp"

#include <algorithm>
#include <cmath>

#include "bake/quantise.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/kinematics.hpp"
#include "robot/read/xml_file.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Limits = bake::IndexLimits<std::uint16_t>;

/// The range of frames, less the accumulated rounding of all joints.
constexpr double kMostCells = 1.0 * kMaxFrameTranslation / kFrameCell - 4.0 * kMaxJoints;
/// The far side of a link's sphere, as a multiple of the distance of the link's furthest point.
constexpr double kSphereReach = 2.02;

double travel_of(const ModelJoint& joint) {
  return joint.type == JointType::prismatic
             ? std::max(std::fabs(joint.lower), std::fabs(joint.upper))
             : 0;
}

double furthest_of(const ModelLink& link) {
  double furthest = 0;
  for (const Vector3& vertex : link.mesh.vertices) {
    furthest = std::max(furthest, length_of(vertex));
  }
  return furthest;
}

/// Sums over joints.
struct Reach {
  double turns = 0;   ///< bounds on the link's distance from rotating joints, added up
  double slides = 0;  ///< number of prismatic joints

  void add(const Model& model, const ModelLink& link, const std::vector<std::size_t>& inwards) {
    double reach = furthest_of(link);
    for (const std::size_t number : inwards) {
      const ModelJoint& joint = model.joints[number];
      (joint.type == JointType::prismatic ? slides : turns) +=
          joint.type == JointType::prismatic ? 1 : reach;
      reach += travel_of(joint) + length_of(joint.fixed.translation);
    }
  }
};

/// The finest cell with which the reaches of any two links fit the guard's sums.
double finest_for_reaches(const Model& model) {
  constexpr double kRounding = 1.01;  // covers motion by the lattice, too
  const double turn = std::ldexp(256 * unit_of_coordinate(JointType::revolute, 1), kReachBits);
  const double slide = std::ldexp(256 * unit_of_coordinate(JointType::prismatic, 1), kReachBits);
  double finest = 0;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      const JointsBetween joints = joints_between(model, a, b);
      Reach reach;
      reach.add(model, model.links[a], joints.of_a);
      reach.add(model, model.links[b], joints.of_b);
      const double most = UINT32_MAX / kRounding - slide * reach.slides;
      finest = most > 0 ? std::max(finest, turn * reach.turns / most) : finest;
    }
  }
  return finest;
}

/// A bound on the distance of any point of a link's sphere from the base.
double reach_of(const Model& model) {
  std::vector<double> joints;
  double most = 0;
  for (const ModelJoint& joint : model.joints) {
    const double before = joint.parent == kNoJoint ? 0 : joints[joint.parent];
    joints.push_back(before + length_of(joint.fixed.translation) + travel_of(joint));
    most = std::max(most, joints.back());
  }
  for (const ModelLink& link : model.links) {
    most = std::max(
        most, kSphereReach * furthest_of(link) + (link.joint == kNoJoint ? 0 : joints[link.joint]));
  }
  return most;
}

}  // namespace

void check_counts(const Model& model, const std::string& path) {
  if (model.joints.size() > kMaxJoints) {
    throw UserError(path, "has ", model.joints.size(), " moving joints, firmware holds ",
                    kMaxJoints, "; make those fixed that matter least, or bake it in parts");
  }
  if (model.links.size() > kMaxLinks) {
    throw UserError(path, "has ", model.links.size(), " links with a <collision>, firmware holds ",
                    kMaxLinks, "; put those that are fixed to each other into one link");
  }
  if (model.joints.empty()) {
    throw UserError(path,
                    "has no joint that moves, so there is nothing to guard; give it one, or "
                    "bake its links' meshes by `flashbvh bake`");
  }
}

double robot_cell(const Model& model, const std::optional<double>& wanted,
                  const std::string& path) {
  const double reach = reach_of(model);
  if (!is_coordinate(reach)) {
    throw UserError(path, "reaches over 3.4e38 m far; correct its origins and limits");
  }
  const double finest_for_frames = reach / kMostCells;
  if (wanted && *wanted < finest_for_frames) {
    throw UserError(path, "reaches up to ", significant(reach, 4),
                    " m far, too far for frames in cells of ", shortest(*wanted),
                    " m; the finest that does is --cell ", shortest(finest_for_frames));
  }
  double finest = std::max(finest_for_frames, finest_for_reaches(model));
  for (const ModelLink& link : model.links) {
    finest = std::max(finest, bake::finest_cell(bake::extent_of(link.mesh)));
  }
  return wanted.value_or(finest);
}

InputMesh link_input(const ModelLink& link, const std::string& path) {
  return input_of(at_element(path, "link", link.name), link.mesh, degenerate_triangles(link.mesh),
                  link.precision);
}

double link_deviation(const ModelLink& link, double cell) {
  return bake::deviation(link.mesh, cell) + std::sqrt(3.0) * link.precision;
}

bool fits_firmware(const BakedPart& part) {
  return part.triangles.size() <= Limits::kMost && part.vertices.size() <= Limits::kMost &&
         part.nodes.size() <= Limits::kMost && part.leaf_count <= Limits::kMostLeaves;
}

BakedLink bake_link(const ModelLink& link, double cell, std::uint32_t leaf_size,
                    const std::string& path, const simplify::Coarsening* coarse) {
  const InputMesh input = link_input(link, path);
  BakeOptions options;
  options.unit = "m";
  options.cell = cell;
  options.leaf_size = leaf_size;
  BakedMesh baked = coarse != nullptr ? bake(input, options, *coarse) : bake(input, options);
  BakedLink made = std::get<BakedLink>(std::move(baked.tree));
  made.unit = Unit::m;
  made.name = link.name.substr(0, bake::kMaxNameSize);
  return made;
}

}  // namespace flashbvh::tool
