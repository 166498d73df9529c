// flashbvh robot: a URDF as C++ for firmware, with what can collide.
#include <filesystem>
#include <memory>
#include <set>

#include "cli/baked_robot.hpp"
#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "cli/robot_output.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct OutputArguments : RobotArguments {
  std::string folder;
  std::string name;
  std::string depfile;
  bool json = false;
};

void add_files(const OutputArguments& arguments, const OutputName& name, SourceFiles sources,
               FileSet& files) {
  const std::string stem = (std::filesystem::path(arguments.folder) / name.stem).string();
  const auto add = [&](const char* extension, std::string text) {
    refuse_to_replace_inputs(stem + extension, {arguments.urdf});
    files.add(stem + extension, std::move(text));
  };
  add(".robot.hpp", std::move(sources.header));
  add(".robot.cpp", std::move(sources.source));
}

/// What was read, as make and Ninja have it.
std::string dependencies(const OutputArguments& arguments, const OutputName& name,
                         const Model& model) {
  std::set<std::string> read = {arguments.urdf};
  if (!arguments.srdf.empty()) {
    read.insert(arguments.srdf);
  }
  for (const ModelLink& link : model.links) {
    read.insert(link.files.begin(), link.files.end());
  }
  const auto escaped = [](const std::string& path) {
    std::string text;
    for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
      text += c == ' ' || c == '#' ? concat("\\", c) : c == '$' ? "$$" : std::string(1, c);
    }
    return text;
  };
  std::string text = escaped(arguments.folder + "/" + name.stem + ".robot.hpp") + ":";
  for (const std::string& path : read) {
    text += " \\\n  " + escaped(path);
  }
  return text + "\n";
}

void make_robot(const OutputArguments& arguments) {
  Warnings warnings;
  const BakedRobot baked = baked_robot(described_robot(arguments, warnings), arguments, warnings);
  const OutputName name = arguments.name.empty() ? distinct_names({baked.model.name}).front()
                                                 : output_name(arguments.urdf, arguments.name);
  FileSet files;
  add_files(arguments, name, robot_sources(baked.model, *baked.fixed, baked.links, name), files);
  if (!arguments.depfile.empty()) {
    refuse_to_replace_inputs(arguments.depfile, {arguments.urdf});
    files.add(arguments.depfile, dependencies(arguments, name, baked.model));
  }
  files.write([&] {
    warnings.print();
    (arguments.json ? print_robot_json : print_robot)(baked.model, baked.links, *baked.fixed,
                                                      baked.pairs);
    flush_output();
  });
}

}  // namespace

void add_robot(CLI::App& app) {
  const auto arguments = std::make_shared<OutputArguments>();
  OutputArguments& a = *arguments;
  CLI::App* const command = app.add_subcommand(
      "robot",
      "Bake a robot (URDF) into C++ arrays: joints, links, and which pairs of links can collide.\n"
      "Lengths are in metres, angles in radians.");
  add_robot_options(*command, "URDF", a);
  command->add_option("-o,--output", a.folder, "Folder for the results; made if there is none")
      ->type_name("DIR")
      ->required();
  command
      ->add_option("--name", a.name,
                   "Name of the files and of the namespace; default: that of the robot")
      ->type_name("NAME");
  command
      ->add_option("--depfile", a.depfile,
                   "Write what was read, for make and Ninja: the URDF, the SRDF and the meshes")
      ->type_name("FILE");
  command->add_flag("--json", a.json, "One JSON object");
  command->callback([arguments] { make_robot(*arguments); });
}

}  // namespace flashbvh::tool
