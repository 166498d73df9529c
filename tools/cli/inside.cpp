// flashbvh inside: the firmware's point in solid, on the desktop.
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/post_mesh.hpp"
#include "evaluate/points.hpp"
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

const char* name_of(PointSide side) {
  return side == PointSide::inside ? "inside" : side == PointSide::outside ? "outside" : "surface";
}

void ask_all(const InsideArguments& arguments) {
  const ImageFile image(arguments.image);
  const std::vector<Point> points = read_lattice_points(arguments.points, image.cell());
  std::vector<PointAnswer> answers;
  for (const Point& point : points) {
    const auto answer =
        ask_post_mesh<PointAnswer>(image, [&](const auto& mesh) { return inside(mesh, point); });
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
  std::size_t number = 0;
  for (const PointAnswer& answer : answers) {
    if (arguments.json) {
      const nlohmann::ordered_json line = {{"point", number},
                                           {"where", name_of(answer.side)},
                                           {"visits", answer.visits},
                                           {"status", "ok"}};
      std::cout << line.dump() << "\n";
    } else {
      std::cout << std::setw(6) << number << "  " << std::left << std::setw(9)
                << name_of(answer.side) << std::right << std::setw(11) << answer.visits << "\n";
    }
    ++number;
  }
  flush_output();
}

}  // namespace

void add_inside(CLI::App& app) {
  const auto arguments = std::make_shared<InsideArguments>();
  CLI::App* const command = app.add_subcommand(
      "inside",
      "Tell which points lie inside a closed mesh, outside, or on its surface, by the firmware's "
      "own code.");
  command->add_option("IMAGE", arguments->image, "Image (.fbvh)")->required();
  command
      ->add_option("--points", arguments->points,
                   "A point a line, in the mesh's frame and unit, taken to the nearest cell; 3 "
                   "numbers")
      ->required()
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "One JSON object a point");
  command->callback([arguments] { ask_all(*arguments); });
}

}  // namespace flashbvh::tool
