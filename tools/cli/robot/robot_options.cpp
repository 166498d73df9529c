#include "cli/robot/robot_options.hpp"

#include "cli/commands.hpp"

namespace flashbvh::tool {

void add_described_options(CLI::App& command, const std::string& name, RobotRequest& request) {
  add_option(command, name.c_str(), request.urdf, "FILE", "The robot (URDF)")->required();
  repeated(
      add_option(command, "--package", request.packages, "NAME=DIR",
                 "Folder of the package NAME, for meshes at package://NAME/...; may be repeated. "
                 "\nDefault: the first folder of that name next to the robot's file or above it"));
  command.add_flag("--visual-too", request.visual_too,
                   "Links with visual shapes alone collide by them; without it, with nothing");
}

void add_believe(CLI::App& command, RobotRequest& request, const std::string& what) {
  repeated(add_option(command, "--believe", request.believed, "LINK,LINK", what));
}

void add_time(CLI::App& command, RobotRequest& request, const std::string& late) {
  add_option(command, "--time", request.time, "SECONDS", late + ". \nDefault: as long as it takes");
}

void add_distances(CLI::App& command, RobotRequest& request) {
  add_option(command, "--stop", request.stop, "LENGTH", "Links nearer than this must stop")
      ->capture_default_str();
  add_option(command, "--warn", request.warn, "LENGTH",
             "Links nearer than this are warned of; default: --stop");
}

void add_baking_options(CLI::App& command, RobotRequest& request) {
  add_option(command, "--srdf", request.srdf, "FILE",
             "Pairs of links that need no guard; those that can collide are an error");
  add_believe(command, request,
              "Two links that --srdf disables and that can collide: don't guard them; may be "
              "repeated");
  add_option(command, "--cell", request.cell, "LENGTH",
             "Size of a lattice cell; default: the finest that all the links fit");
  command
      .add_option("--leaf-size", request.leaf_size,
                  "Most triangles in a leaf; default: up to 4, as 27 bytes of flash a triangle "
                  "allow")
      ->check(CLI::Range(1, 16))
      ->each([&request](const std::string&) { request.has_leaf_size = true; });
  add_option(
      command, "--simplify", request.simplify, "LENGTH",
      "Firmware gets fewer triangles, within LENGTH of the links', proven; what can collide is "
      "decided\nwith all triangles. A guard stops earlier by up to four times LENGTH");
  add_option(
      command, "--fit", request.fit, "BYTES",
      "Simplify as little as it takes for the image to be no larger, and choose --leaf-size");
  repeated(
      add_option(command, "--pair", request.pairs, "LINK,LINK=STOP[,WARN]",
                 "Distances of two links for which --stop and --warn don't hold; may be repeated"));
  repeated(
      add_option(command, "--zone", request.zones, "JOINT=LENGTH",
                 "Two links may touch so far about the joint between them; 0: nowhere; may be "
                 "repeated. \nDefault: as far as they do, or farther where that stops too much"));
  add_time(command, request,
           "What is not decided by then is undecided, and guarded; links not simplified keep more "
           "triangles");
}

}  // namespace flashbvh::tool
