// flashbvh inside: runs the firmware's point-in-solid query on the desktop.
#include "cli/query/scene.hpp"
#include "flashbvh/solid.hpp"

namespace flashbvh::tool {
namespace {

struct InsideArguments {
  std::string image;
  std::string points;
  bool json = false;
};

const char* side_name(PointSide side) {
  return side == PointSide::inside ? "inside" : side == PointSide::outside ? "outside" : "surface";
}

void query_points(const InsideArguments& arguments) {
  const ImageFile image(arguments.image);
  Json lines = Json::array();
  for (const Point& point : read_lattice_points(arguments.points, image.cell())) {
    const auto answer =
        query_post_mesh<PointAnswer>(image, [&](const auto& mesh) { return inside(mesh, point); });
    if (answer.status == Status::not_closed) {
      throw UserError(image.path(),
                      "is no closed surface and has no inside; `flashbvh bake` says where it is "
                      "open");
    }
    lines.push_back({{"point", lines.size()},
                     {"where", side_name(answer.side)},
                     {"visits", answer.visits},
                     {"status", "ok"}});
  }
  print_answers(arguments.json, lines, image.name(),
                {number_column("point", "point"), word_column("where", "where"),
                 number_column("visits", "visits")});
}

}  // namespace

void add_inside(CLI::App& app) {
  auto [command, a] = add_command<InsideArguments>(
      app, "inside",
      "Print which points lie inside a closed mesh, outside, or on its surface, by the firmware's "
      "own code.",
      query_points);
  add_option(command, "IMAGE", a.image, "FILE.fbvh", "Image (.fbvh)")->required();
  add_option(command, "--points", a.points, "FILE",
             "A point a line, in the mesh's frame and unit, taken to the nearest cell; 3 "
             "numbers")
      ->required();
  command.add_flag("--json", a.json, "One JSON object a point");
  add_example(command, "inside baked/plate.fbvh --points points.txt",
              "prints inside, outside or surface for each point");
}

}  // namespace flashbvh::tool
