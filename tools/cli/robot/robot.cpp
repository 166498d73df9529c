// flashbvh robot: bakes a URDF to an image for firmware, and reports the pairs that can collide.
#include <algorithm>
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/page.hpp"
#include "cli/robot/robot_options.hpp"
#include "cli/robot/robot_output.hpp"
#include "robot/baked/robot_writer.hpp"
#include "robot/pipeline/simplified_links.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct OutputArguments : RobotRequest {
  std::string folder;
  std::string name;
  std::string depfile;
  std::string format = "c";
  std::string page;
  bool dry_run = false;
  bool json = false;
};

using ImageWords = std::vector<std::uint32_t>;

void add_files(const OutputArguments& arguments, const OutputName& name, const BakedRobot& baked,
               const ImageWords& image, FileSet& files) {
  const std::string stem = (std::filesystem::path(arguments.folder) / name.stem).string();
  if (arguments.format != "c") {
    files.add(stem + ".robot", as_bytes(image));
  }
  if (arguments.format != "image") {
    SourceFiles sources = robot_in_c(image, baked.model, baked.robot(), baked.unguarded, name);
    files.add(stem + ".robot.h", std::move(sources.header));
    files.add(stem + ".robot.c", std::move(sources.source));
  }
}

/// The input files, as a depfile for make and Ninja.
std::string dependencies(const OutputArguments& arguments, const OutputName& name,
                         const Model& model) {
  const auto escaped = [](const std::string& path) {
    std::string text;
    for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
      const bool is_escaped = c == ' ' || c == '#';
      text += is_escaped ? "\\" : c == '$' ? "$" : "";
      text += c;
    }
    return text;
  };
  const char* const extension = arguments.format == "image" ? ".robot" : ".robot.h";
  std::string text =
      escaped((std::filesystem::path(arguments.folder) / (name.stem + extension)).string()) + ":";
  for (const std::string& path : files_read(arguments, model)) {
    text += " \\\n  " + escaped(path);
  }
  return text + "\n";
}

/// For each a joint, a point in cells of its frame, and a radius in metres.
Json drawn_zones(const BakedRobot& robot) {
  Json zones = Json::array();
  for (const JointZone& zone : robot.zones) {
    const auto& [x, y, z] = zone.shape.middle;
    zones.push_back(
        {zone.joint, x / robot.cell, y / robot.cell, z / robot.cell, zone.shape.radius});
  }
  return zones;
}

/// What to do first.
Headline advice(const BakedRobot& robot) {
  const auto undecided = std::count_if(
      robot.pairs.begin(), robot.pairs.end(),
      [](const PairVerdict& pair) { return pair.verdict == MatrixVerdict::undecided; });
  const std::string of_all = concat(" of ", robot.pairs.size(), " pairs of links ");
  if (undecided != 0) {
    return {3, concat("Give more --time: ", undecided, of_all, "are undecided")};
  }
  if (!robot.unguarded.empty()) {
    return {1, concat("Protect otherwise: at ", robot.unguarded.size(), of_all,
                      "no guard looks, or only outside a joint zone")};
  }
  return {0, "Flash it: a guard looks at all links that can collide"};
}

std::string robot_page(const OutputArguments& arguments, const BakedRobot& robot,
                       const ImageWords& image, const Json& facts) {
  const auto nearer = [&](const char* what, const std::string& metres) {
    return concat(what, ": links nearer than ", significant(1000 * std::stod(metres), 6), " mm",
                  arguments.pairs.empty() ? "" : ", but for --pair");
  };
  std::vector<Headline> headlines = {advice(robot),
                                     {4, nearer("stop", arguments.stop)},
                                     {1, nearer("warn", arguments.warn.value_or(arguments.stop))}};
  add_unguarded(robot.model, robot.unguarded, headlines);
  headlines.push_back({0, concat("Guarded: ", robot.robot().pair_count, " of ", robot.pairs.size(),
                                 " pairs of links")});
  return page_text("robot", robot.model.name, headlines, Json::array({facts}),
                   {{"image", base64(image.data(), image.size() * sizeof image[0])},
                    {"zones", drawn_zones(robot)}});
}

void make_robot(const OutputArguments& arguments) {
  if (arguments.folder.empty() && !arguments.dry_run) {
    throw CLI::RequiredError("--output or --dry-run");
  }
  Warnings warnings;
  Model model = described_robot(arguments, warnings);
  Progress progress(steps_of(model));
  const BakedRobot baked = baked_robot(std::move(model), arguments, shown_by(progress), warnings);
  const OutputName name = arguments.name.empty() ? distinct_names({baked.model.name}).front()
                                                 : output_name(arguments.urdf, arguments.name);
  const ImageWords image = image_of(baked, name.stem);
  const std::size_t bytes = image.size() * sizeof image[0];
  const Json facts = robot_json(baked, bytes);
  FileSet files(files_read(arguments, baked.model));
  if (!arguments.dry_run) {
    add_files(arguments, name, baked, image, files);
  }
  if (!arguments.depfile.empty()) {
    files.add(arguments.depfile, dependencies(arguments, name, baked.model));
  }
  if (!arguments.page.empty()) {
    files.add(arguments.page, robot_page(arguments, baked, image, facts));
  }
  files.write([&] {
    warnings.print();
    if (arguments.json) {
      print_object(facts);
    } else {
      print_robot(baked, facts);
    }
  });
}

}  // namespace

void add_robot(CLI::App& app) {
  auto [command, a] =
      add_command<OutputArguments>(app, "robot",
                                   "Bake a robot (URDF) into an image: joints, links, "
                                   "and which pairs of links can collide.\n"
                                   "Lengths are in metres, angles in radians.",
                                   make_robot);
  add_described_options(command, "URDF", a);
  add_distances(command, a);
  add_baking_options(command, a);
  command.add_flag("--limit", a.limits,
                   "Firmware calls limit(): links that are nowhere farther apart than their stop "
                   "distance and a\ntenth, so that it could never let them out, are an error");
  add_option(command, "-o,--output", a.folder, "DIR",
             "Folder for the results; made if there is none");
  command.add_flag("--dry-run", a.dry_run,
                   "Print the tables, what is wrong and what --simplify would save, and write no "
                   "image");
  add_choice(
      command, "--format", a.format, {"c", "image", "both"},
      "What to write: the image as an array of C and C++ (c), as a binary file (image), or both");
  add_option(command, "--name", a.name, "NAME",
             "Name of the files and their contents; default: that of the robot")
      ->check([](const std::string& name) { return name.empty() ? "is empty; give a name" : ""; });
  add_option(command, "--depfile", a.depfile, "FILE",
             "Write what was read, for make and Ninja: the robot's files, the SRDF and the meshes");
  add_option(command, "--report", a.page, "PAGE.html",
             "Write a page: a robot that answers, and what can collide");
  command.add_flag("--json", a.json, "One JSON object");
  add_example(command, "robot arm.urdf --stop 0.005 --warn 0.03 -o baked", "writes C");
}

}  // namespace flashbvh::tool
