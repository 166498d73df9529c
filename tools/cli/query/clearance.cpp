// flashbvh clearance: runs the firmware's distance queries on the desktop.
#include <string>

#include "cli/query/scene.hpp"

namespace flashbvh::tool {
namespace {

struct ClearanceArguments : PosedImages {
  bool json = false;
};

Json json_of(std::size_t pose, const ClearanceAnswer& found, double cell, const std::string& unit) {
  Json line = {{"pose", pose}, {"unit", unit}};
  if (found.nearest) {
    const NearestPair& pair = *found.nearest;
    line.update({{"distance", pair.distance * cell},
                 {"lower", unit_length(pair.points.lower, cell)},
                 {"upper", unit_length(pair.points.upper, cell)},
                 {"triangles", {pair.triangles.a, pair.triangles.b}},
                 {"point_a", point_json(pair.points.point_a, cell)},
                 {"point_b", point_json(pair.points.point_b, cell)}});
  } else {
    line.update({{"distance", nullptr}, {"lower", unit_length(found.lower, cell)}});
    line["upper"] = found.upper == UINT32_MAX ? Json() : Json(unit_length(found.upper, cell));
    line.update({{"triangles", nullptr}, {"point_a", nullptr}, {"point_b", nullptr}});
  }
  line.update({{"visits", found.visits},
               {"triangle_pairs", found.triangle_pairs},
               {"status", found.in_range ? "ok" : "out_of_range"}});
  return line;
}

std::string distance_text(const Json& line) {
  const std::string unit = line["unit"];
  return line["distance"].is_null() ? ">= " + length_text(line["lower"], unit)
                                    : length_text(line["distance"], unit);
}

std::string triangles_text(const Json& line) {
  const Json& triangles = line["triangles"];
  return triangles.is_array() ? concat(triangles[0].dump(), " ", triangles[1].dump())
                              : "out of range";
}

void query_distances(const ClearanceArguments& arguments) {
  const Scene scene(arguments);
  check_has_clearance(scene.a);
  Json lines = Json::array();
  Witness<std::uint32_t> hint;
  for (const Pose& pose : scene.poses(arguments)) {
    const ClearanceAnswer found = clearance(scene.a.tree(), scene.b.tree(), pose, hint);
    if (found.status != Status::done) {
      throw UserError(arguments.poses, "pose ", lines.size(),
                      " can't be answered: ", status_name(found.status));
    }
    lines.push_back(json_of(lines.size(), found, scene.a.cell(), scene.unit()));
  }
  print_answers(arguments.json, lines, scene.names() + ", distance",
                {number_column("pose", "pose"),
                 {"distance", distance_text, true},
                 {"triangles", triangles_text, true},
                 number_column("visits", "visits"),
                 number_column("triangle pairs", "triangle_pairs")});
}

}  // namespace

void add_clearance(CLI::App& app) {
  auto [command, a] = add_command<ClearanceArguments>(
      app, "clearance",
      "Print how far A and B are apart, by the firmware's own code. Distances are between "
      "surfaces: a mesh inside another one is as far as its wall.",
      query_distances);
  add_posed_images(command, a)->required();
  command.add_flag("--json", a.json, "One JSON object a pose");
  add_example(command, "clearance baked/plate.fbvh baked/peg.fbvh --poses poses.txt",
              "prints a distance for each pose");
}

}  // namespace flashbvh::tool
