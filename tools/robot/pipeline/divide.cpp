#include "robot/pipeline/divide.hpp"

#include <algorithm>

#include "robot/baked/bake_links.hpp"
#include "text/numbers.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// Adds a part of a link as another link.
std::size_t add_part(std::size_t of, bake::SourceMesh mesh, const std::string& where,
                     const RobotRequest& request, Divided& robot) {
  ModelLink part;
  part.name = robot.model.links[of].name;
  part.joint = robot.model.links[of].joint;
  part.mesh = std::move(mesh);
  part.sources = {concat("outside ", where)};
  part.source_begins = {0};
  part.precision = robot.model.links[of].precision;
  robot.wholes.push_back(bake_part(link_input(part, request.urdf), robot.cell, request.leaf_size));
  robot.model.links.push_back(std::move(part));
  ++robot.model.part_count;
  return robot.model.links.size() - 1;
}

/// UserError if the links and their parts are more than firmware holds.
void check_parts(const Model& model, const std::string& path) {
  if (model.links.size() > kMaxLinks) {
    throw UserError(path, "has ", model.links.size() - model.part_count,
                    " links with a <collision> and ", model.part_count,
                    " parts of them to guard next to joint zones, firmware holds ", kMaxLinks,
                    " of both; give more --time, or joints a larger --zone");
  }
}

/// Adds the reaches of the parts; none exceeds its whole link's.
void add_reaches(Divided& robot) {
  const std::size_t first = robot.reaches.size();
  robot.reaches.resize(robot.model.links.size());
  for_each_in_parallel(robot.reaches.size() - first, [&](std::size_t i) {
    std::vector<double>& reaches = robot.reaches[first + i];
    reaches = reaches_of(robot.model, first + i, robot.cell, robot.options.deadline);
    const std::size_t link = find_link(robot.model, robot.model.links[first + i].name);
    const std::vector<double>& whole = robot.reaches[link];
    std::transform(reaches.begin(), reaches.end(), whole.begin(), reaches.begin(),
                   [](double part, double all) { return std::min(part, all); });
  });
}

}  // namespace

Divided divide(Prepared prepared, Decided decided, const RobotRequest& request) {
  Divided robot = {std::move(prepared), std::move(decided), {}};
  std::vector<std::vector<ZoneParts>> parts =
      decide_parts(robot.model, robot.zones, robot.cell, robot.options, robot.pairs);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PairVerdict& pair = robot.pairs[i];
    for (ZoneParts& part : parts[i]) {
      const JointZone& zone = robot.zones[*pair.zone];
      const std::string where = radius_text(robot.model, zone.shape.radius, zone.joint);
      const std::size_t a = add_part(pair.a, std::move(part.a), where, request, robot);
      pair.bodies.emplace_back(a, add_part(pair.b, std::move(part.b), where, request, robot));
    }
  }
  robot.sizes = link_sizes(robot.model);
  check_parts(robot.model, request.urdf);
  add_reaches(robot);
  // After parts: a pair whose parts never come near needs no guard.
  robot.unguarded = unguarded_pairs(robot.pairs, robot.zones);
  return robot;
}

}  // namespace flashbvh::tool
