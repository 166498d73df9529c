#include "robot/pipeline/baked_robot.hpp"

#include <algorithm>

#include "bake/image_bytes.hpp"
#include "image/simplify_options.hpp"
#include "robot/baked/robot_image.hpp"
#include "robot/pipeline/simplified_links.hpp"

namespace flashbvh::tool {
namespace {

/// The part of --time at which simplifying ends; distance tables get the rest.
constexpr double kPartForSimplifying = 0.95;

/// UserError if firmware cannot hold a link as it is.
void check_wholes(const Prepared& robot, const RobotRequest& request) {
  for (std::size_t i = 0; i < robot.wholes.size(); ++i) {
    if (!request.simplify && !request.fit && !fits_firmware(robot.wholes[i])) {
      (void)bake_link(robot.model.links[i], robot.cell, request.leaf_size, request.urdf);
    }
  }
}

/// The guarded pairs. Pairs that are always within their warn distance get no warning: neighbours
/// next to their zone, and pairs without distances of their own.
std::vector<GuardedPair> guarded_pairs(const Divided& robot) {
  std::vector<GuardedPair> guarded;
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.is_guarded) {
      const auto [link_a, link_b, stop, warn] = robot.distances.of(pair.a, pair.b);
      const bool is_near =
          pair.is_warned && find_pair(robot.distances.own, pair.a, pair.b) == nullptr;
      for (const auto& [a, b] : pair.bodies) {
        guarded.push_back({a, b, stop, pair.zone || is_near ? stop : warn});
      }
    }
  }
  std::sort(guarded.begin(), guarded.end(), [](const GuardedPair& p, const GuardedPair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return guarded;
}

/// Warns if time was too short, or if parts next to joint zones took so much flash that simplifying
/// exceeds the zones' limit.
void warn_of_simplified(const SimplifiedLinks& simplified, const Model& model,
                        const RobotRequest& request, Warnings& warnings) {
  if (const std::set<std::string> links = simplified.unfinished(model); !links.empty()) {
    warnings.add("--time " + *request.time,
                 concat("left too little to simplify ", joined(links, quoted),
                        ": they may have more triangles than it takes; give more"));
  }
  if (simplified.exceeds_expected()) {
    warnings.add("--fit " + *request.fit,
                 concat("takes --simplify ", shortest(simplified.length()),
                        ", more than joint zones were chosen for; give that in its place, or a "
                        "guard may stop next to zones"));
  }
}

/// Bakes firmware's links and tables.
BakedRobot bake_for_firmware(Divided divided, SimplifiedLinks& simplified,
                             const RobotRequest& request, const Told& told) {
  BakedRobot robot = {std::move(divided), {}, 0, 0, 0, {}};
  const std::vector<GuardedPair> pairs = guarded_pairs(robot);
  const std::vector<WholeMesh> wholes = views_of(robot.wholes);
  {
    const FixedRobot bare(robot.model, wholes, {}, robot.cell, pairs, robot.reaches);
    robot.own_bytes = own_image_bytes(robot.model, bare.robot(), robot.unguarded, robot.model.name);
  }
  robot.links = simplified.baked(robot.model, robot.own_bytes,
                                 deadline_of(request, kPartForSimplifying), told);
  robot.simplified = simplified.length();
  robot.leaf_size = simplified.leaf_size();
  std::vector<double> deviations;
  std::vector<Mesh> meshes;
  for (const BakedLink& link : robot.links) {
    deviations.push_back(link.deviation);
    meshes.push_back(link.view());
  }
  robot.fixed = std::make_unique<FixedRobot>(robot.model, wholes, meshes, robot.cell, pairs,
                                             robot.reaches, deviations);
  // Last: tables hold distances between firmware's meshes.
  told("distance tables", 0);
  robot.fixed->set_distance_tables(
      distance_tables_of(robot.model, robot.robot(), deadline_of(request, 1)));
  return robot;
}

}  // namespace

BakedRobot baked_robot(Model model, const RobotRequest& request, const Told& told,
                       Warnings& warnings) {
  check_simplify_or_fit(request.simplify.has_value(), request.fit.has_value());
  Prepared prepared = prepare(std::move(model), request, told, warnings);
  // Requests that no work can meet are refused before pairs are decided.
  check_image(prepared.model, prepared.model.name, prepared.cell);
  check_wholes(prepared, request);
  SimplifiedLinks simplified(prepared.model, prepared.cell, request);
  Decided decided = decide(prepared, request, simplified.early(),
                           "guarded all over, and a guard would always say stop", told, warnings);
  // Before parts: an SRDF names links, and it is refused by verdicts alone.
  check_disabled(prepared.model, decided.pairs, request.srdf, warnings);
  Divided divided = divide(std::move(prepared), std::move(decided), request);
  warn_of_guard(divided, request, warnings);
  BakedRobot robot = bake_for_firmware(std::move(divided), simplified, request, told);
  warn_of_simplified(simplified, robot.model, request, warnings);
  return robot;
}

std::vector<std::uint32_t> image_of(const BakedRobot& robot, const std::string& name) {
  std::vector<std::vector<std::uint32_t>> meshes;
  for (const BakedLink& link : robot.links) {
    meshes.push_back(bake::image_of(link));
  }
  return robot_image(robot.model, robot.robot(), robot.unguarded, meshes, name);
}

}  // namespace flashbvh::tool
