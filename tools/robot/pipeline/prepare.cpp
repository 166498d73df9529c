#include "robot/pipeline/prepare.hpp"

#include "robot/baked/bake_links.hpp"
#include "robot/matrix/unguarded.hpp"
#include "robot/read/urdf.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The weight of baking a link; deciding a pair has weight 1.
constexpr double kBakingWeight = 0.1;

/// Bakes trees for deciding pairs. Their leaves are as large as in firmware's trees, so that a
/// witness is the same pair of triangles.
std::vector<BakedPart> bake_wholes(const Prepared& robot, const RobotRequest& request,
                                   const Told& told, Warnings& warnings) {
  const std::vector<ModelLink>& links = robot.model.links;
  std::vector<BakedPart> wholes(links.size());
  for_each_in_parallel(links.size(), [&](std::size_t i) {
    told("baking " + links[i].name, kBakingWeight);
    wholes[i] = bake_part(link_input(links[i], request.urdf), robot.cell, request.leaf_size);
  });
  for (std::size_t i = 0; i < links.size(); ++i) {
    const InputMesh input = link_input(links[i], request.urdf);
    warn_of_precision(input, robot.cell, warnings);
    warn_of_place(wholes[i].origin, input.path, warnings);
  }
  return wholes;
}

/// UserError, at the option that gives it, if a distance is too large for firmware.
void check_ranges(const AllDistances& distances, const RobotRequest& request, double cell) {
  const auto check = [&](double distance, const std::string& place) {
    check_length(distance, kMaxGuardDistance, place, cell);
  };
  check(distances.stop, "--stop " + request.stop);
  check(distances.warn, "--warn " + request.warn.value_or(request.stop));
  for (std::size_t i = 0; i < distances.own.size(); ++i) {
    check(distances.own[i].warn, "--pair " + request.pairs[i]);
  }
}

}  // namespace

double steps_of(const Model& model) {
  const auto count = static_cast<double>(model.links.size());
  return kBakingWeight * count + count * (count - 1) / 2;
}

Model described_robot(const RobotRequest& request, Warnings& warnings) {
  (void)usual_distances(request);
  Model model = read_urdf(request.urdf, packages_of(request.packages), request.srdf, warnings,
                          request.visual_too);
  check_counts(model, request.urdf);
  for (const std::string& names : request.believed) {
    const std::string place = "--believe " + names;
    const auto [a, b] = links_of(model, place, names);
    believe(a, b, place, model);
  }
  return model;
}

Prepared prepare(Model model, const RobotRequest& request, const Told& told, Warnings& warnings) {
  Prepared robot = {std::move(model), 0, {}, {}};
  robot.distances = all_distances(robot.model, request);
  robot.cell = robot_cell(robot.model, given_cell(request), request.urdf);
  robot.radii = zone_radii(robot.model, request.zones, robot.cell);
  check_ranges(robot.distances, request, robot.cell);
  robot.sizes = link_sizes(robot.model);
  warn_of_sizes(robot, request, warnings);
  robot.wholes = bake_wholes(robot, request, told, warnings);
  return robot;
}

}  // namespace flashbvh::tool
