// flashbvh clearance: runs the firmware's distance queries on the desktop.
#include <optional>
#include <string>
#include <vector>

#include "cli/query/scene.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct ClearanceArguments : PosedImages {
  std::string pairs;
  std::optional<double> within;
  bool json = false;
};

Json json_of(std::size_t pose, bool is_within, const ClearanceAnswer& found, double cell,
             const std::string& unit) {
  Json line = {{"pose", pose}, {"unit", unit}};
  if (is_within) {
    line["within"] = !found.nearest.empty();
  } else if (!found.in_range) {
    line.update({{"distance", nullptr}, {"lower", unit_length(found.lower, cell)}});
    line["upper"] = found.upper == UINT32_MAX ? Json() : Json(unit_length(found.upper, cell));
    line.update({{"triangles", nullptr}, {"point_a", nullptr}, {"point_b", nullptr}});
  }
  if (!found.nearest.empty()) {
    const NearestPair& pair = found.nearest[0];
    if (!is_within) {  // else this is any near pair's distance, not the meshes'
      line.update({{"distance", pair.distance * cell},
                   {"lower", unit_length(pair.points.lower, cell)},
                   {"upper", unit_length(pair.points.upper, cell)}});
    }
    line.update({{"triangles", {pair.triangles.a, pair.triangles.b}},
                 {"point_a", point_json(pair.points.point_a, cell)},
                 {"point_b", point_json(pair.points.point_b, cell)}});
  }
  line.update({{"visits", found.visits},
               {"triangle_pairs", found.triangle_pairs},
               {"status", found.in_range ? "ok" : "out_of_range"}});
  return line;
}

std::string distance_text(const Json& line) {
  const std::string unit = line["unit"];
  return line.contains("within")      ? (line["within"] ? "yes" : "no")
         : line["distance"].is_null() ? ">= " + length_text(line["lower"], unit)
                                      : length_text(line["distance"], unit);
}

std::string triangles_text(const Json& line) {
  const Json triangles = line.value("triangles", Json());
  return triangles.is_array()     ? concat(triangles[0].dump(), " ", triangles[1].dump())
         : line["status"] == "ok" ? ""
                                  : "out of range";
}

std::vector<ClearanceAnswer> answers_of(const ClearanceArguments& arguments, const Scene& scene) {
  std::vector<ClearanceAnswer> found;
  Witness<std::uint32_t> hint;
  const double cell = scene.a.cell();
  const FineLength reach =
      arguments.within ? fine_length(*arguments.within, cell, kMaxDistance) : FineLength{0};
  for (const Pose& pose : scene.poses(arguments)) {
    found.push_back(arguments.within ? within_distance(scene.a.tree(), scene.b.tree(), pose, reach,
                                                       !arguments.pairs.empty())
                                     : clearance(scene.a.tree(), scene.b.tree(), pose, hint));
    if (found.back().status == Status::distance_out_of_range) {
      throw UserError(arguments.poses, "pose ", found.size() - 1,
                      " puts B so far off that --within is not decidable; use less than ",
                      significant(1e6 * cell, 6));
    }
    if (found.back().status != Status::done) {
      throw UserError(arguments.poses, "pose ", found.size() - 1,
                      " can't be answered: ", status_name(found.back().status));
    }
  }
  return found;
}

void query_distances(const ClearanceArguments& arguments) {
  check_output(arguments.pairs, {arguments.poses});
  const Scene scene(arguments);
  check_has_clearance(scene.a);
  Json lines = Json::array();
  std::string pairs;
  for (const ClearanceAnswer& found : answers_of(arguments, scene)) {
    for (const NearestPair& pair : found.nearest) {
      pairs += concat(lines.size(), " ", pair.triangles.a, " ", pair.triangles.b, "\n");
    }
    lines.push_back(
        json_of(lines.size(), arguments.within.has_value(), found, scene.a.cell(), scene.unit()));
  }
  FileSet files;
  if (!arguments.pairs.empty()) {
    files.add(arguments.pairs, std::move(pairs));
  }
  const char* const what = arguments.within ? "within" : "distance";
  files.write([&] {
    print_answers(arguments.json, lines, concat(scene.names(), ", ", what),
                  {number_column("pose", "pose"),
                   {what, distance_text, true},
                   {"triangles", triangles_text, true},
                   number_column("visits", "visits"),
                   number_column("triangle pairs", "triangle_pairs")});
  });
}

}  // namespace

void add_clearance(CLI::App& app) {
  auto [command, a] = add_command<ClearanceArguments>(
      app, "clearance",
      "Print how far A and B are apart, or whether they are within a distance, by the firmware's "
      "own\ncode. Distances are between surfaces: a mesh inside another one is as far as its wall.",
      query_distances);
  add_posed_images(command, a)->required();
  CLI::Option* const within =
      add_option(command, "--within", a.within, "LENGTH",
                 "Print whether any points are at most this far apart, in the images' unit, "
                 "and of which triangles");
  add_option(command, "--pairs", a.pairs, "FILE",
             "Write `pose a b` for each pair of triangles within that distance, sorted")
      ->needs(within);
  command.add_flag("--json", a.json, "One JSON object a pose");
  add_example(command, "clearance baked/plate.fbvh baked/peg.fbvh --poses poses.txt",
              "prints a distance for each pose");
}

}  // namespace flashbvh::tool
