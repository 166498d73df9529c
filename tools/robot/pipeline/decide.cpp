#include "robot/pipeline/decide.hpp"

#include <algorithm>

#include "robot/baked/fixed_robot.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The parts' deadlines as parts of the whole time; unused time goes to later ones. Zones get most:
/// without its zone, a joint's links are guarded everywhere.
constexpr double kPartForReaches = 0.1;
constexpr double kPartForZones = 0.6;
constexpr double kPartForPairs = 0.8;
constexpr double kPartForParts = 0.9;
/// Simplifying takes as long as decisions on all triangles.
constexpr double kPartBeforeSimplifying = 0.5;

/// All pairs that a joint moves and that may be guarded.
std::vector<GuardedPair> moved_pairs(const Model& model) {
  std::vector<GuardedPair> pairs;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      const DisabledPair* const disabled = find_pair(model.disabled, a, b);
      if (model.links[a].joint != model.links[b].joint &&
          (disabled == nullptr || !disabled->is_believed)) {
        pairs.push_back({a, b, 0, 0});
      }
    }
  }
  return pairs;
}

/// Proofs include firmware's own kinematics. UserError if firmware cannot hold such a fine robot.
MatrixOptions matrix_options(const Prepared& robot, const std::vector<WholeMesh>& meshes,
                             const Reaches& reaches) {
  MatrixOptions options;
  options.stop = robot.distances.stop / robot.cell;
  options.warn = robot.distances.warn / robot.cell;
  for (const GuardedPair& pair : robot.distances.own) {
    options.own.push_back({pair.a, pair.b, pair.stop / robot.cell, pair.warn / robot.cell});
  }
  const FixedRobot fixed(robot.model, meshes, {}, robot.cell, moved_pairs(robot.model), reaches);
  options.slack = std::max(options.slack, kPlacing + fixed.robot().slack / double{kFineOne});
  return options;
}

/// UserError if a guard's slack cannot hold the links' deviations twice. `slack`: of the robot with
/// all triangles, in cells.
void check_slack_for_simplify(double slack, double cell, const RobotRequest& request) {
  constexpr double kLess = 0.99;  // so that rounding to three digits does not exceed it
  const double most = (kMaxGuardDistance / double{kFineOne} - slack) * cell / 2;
  if (request.simplify && simplify_length(request) > most) {
    throw UserError("--simplify " + *request.simplify,
                    "is out of range: a guard would stop this robot wherever it is; give ",
                    significant(kLess * most, 3), " or less");
  }
}

}  // namespace

Decided decide(const Prepared& robot, const RobotRequest& request, double early,
               const std::string& late, const Told& told, Warnings& warnings) {
  const auto until = [&](double part) {
    const bool simplifies = request.simplify || request.fit;
    return deadline_of(request, simplifies ? kPartBeforeSimplifying * part : part);
  };
  const std::vector<WholeMesh> meshes = views_of(robot.wholes);
  Decided decided;
  decided.reaches = all_reaches(robot.model, robot.cell, until(kPartForReaches));
  decided.options = matrix_options(robot, meshes, decided.reaches);
  check_slack_for_simplify(decided.options.slack, robot.cell, request);
  decided.options.early = early / robot.cell;
  decided.options.limits = request.limits;
  told("joint zones", 0);
  decided.options.deadline = until(kPartForZones);
  FoundZones found = joint_zones(robot.model, meshes, robot.cell, decided.options, robot.radii);
  decided.zones = std::move(found.zones);
  decided.late_joints = std::move(found.late_joints);
  decided.options.deadline = until(kPartForPairs);
  decided.pairs = decide_pairs(
      robot.model, meshes, decided.zones, decided.reaches, robot.cell, decided.options,
      [&](std::size_t pair, std::size_t pairs) { told(concat("pair ", pair, " of ", pairs), 1); });
  const auto undecided = std::count_if(
      decided.pairs.begin(), decided.pairs.end(),
      [](const PairVerdict& pair) { return pair.verdict == MatrixVerdict::undecided; });
  if (undecided != 0 && decided.options.is_late()) {
    warnings.add("--time " + *request.time, concat("left ", undecided, " of ", decided.pairs.size(),
                                                   " pairs of links undecided; give more"));
  }
  decided.options.deadline = until(kPartForParts);
  if (!decided.late_joints.empty()) {
    const auto name = [&](std::size_t joint) { return robot.model.joints[joint].name; };
    warnings.add(request.urdf,
                 concat("no time was left to find a zone about ", joined(decided.late_joints, name),
                        ": links that touch there are ", late, "; give more --time"));
  }
  return decided;
}

}  // namespace flashbvh::tool
