// flashbvh inside: runs the firmware's point-in-solid query on the desktop.
#include <iomanip>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "flashbvh/solid.hpp"
#include "image/image_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

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
  const std::vector<Point> points = read_lattice_points(arguments.points, image.cell());
  std::vector<PointAnswer> answers;
  for (const Point& point : points) {
    const auto answer =
        query_post_mesh<PointAnswer>(image, [&](const auto& mesh) { return inside(mesh, point); });
    if (answer.status == Status::not_closed) {
      throw UserError(image.path(),
                      "is no closed surface and has no inside; `flashbvh check` says where it is "
                      "open");
    }
    answers.push_back(answer);
  }
  if (!arguments.json) {
    std::cout << image.name() << "\n point  where         visits\n";
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const char* const side = side_name(answers[i].side);
    if (arguments.json) {
      print_object(
          {{"point", i}, {"where", side}, {"visits", answers[i].visits}, {"status", "ok"}});
    } else {
      std::cout << std::setw(6) << i << "  " << std::left << std::setw(9) << side << std::right
                << std::setw(11) << answers[i].visits << "\n";
    }
  }
  flush_output();
}

}  // namespace

void add_inside(CLI::App& app) {
  auto [command, a] = add_command<InsideArguments>(
      app, "inside",
      "Print which points lie inside a closed mesh, outside, or on its surface, by the firmware's "
      "own code.",
      query_points);
  add_image(command, a.image);
  add_option(command, "--points", a.points, "FILE",
             "A point a line, in the mesh's frame and unit, taken to the nearest cell; 3 "
             "numbers")
      ->required();
  add_json(command, a.json, "One JSON object a point");
  add_example(command, "inside baked/plate.fbvh --points points.txt",
              "prints inside, outside or surface for each point");
}

}  // namespace flashbvh::tool
