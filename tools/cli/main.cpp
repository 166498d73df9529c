// flashbvh: bakes meshes and robots; inspects and queries their images.
#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <string>

#include "cli/commands.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

int fail(const std::string& message) {
  std::cerr << "flashbvh: " << one_line(message) << "\n";
  return kBadInput;
}

/// Prints the error of a command line, and the command that shows the help.
int fail(const CLI::ParseError& error, const CLI::App& app) {
  const auto given = app.get_subcommands();
  const std::string command = given.empty() ? "flashbvh" : "flashbvh " + given[0]->get_name();
  return fail(concat(error.what(), "; see ", command, " --help"));
}

int run(int argc, char** argv) {
  CLI::App app("Bounding volume trees for microcontrollers: bakes meshes, looks at what it baked.",
               "flashbvh");
  app.require_subcommand(0, 1);            // after a command, the name of another is an argument
  app.allow_windows_style_options(false);  // "/part.stl" is a file on every system
  app.set_version_flag("--version", version_text());
  for (AddCommand* const add :
       {add_bake, add_info, add_report, add_collide, add_clearance, add_motion, add_inside, add_ray,
        add_bench, add_robot, add_guard, add_audit}) {
    add(app);
  }
  add_example(app, "bake --help", "prints the options of bake, and an example");
  try {
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& error) {
    flush_output();
    return error.get_exit_code();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      return fail(error, app);
    }
    app.exit(error);  // prints --help and --version
    flush_output();
    return kSuccess;
  }
  if (app.get_subcommands().empty()) {
    return fail("a command is missing; see flashbvh --help");
  }
  flush_output();
  return kSuccess;
}

}  // namespace
}  // namespace flashbvh::tool

int main(int argc, char** argv) {
  try {
    return flashbvh::tool::run(argc, argv);
  } catch (const std::exception& error) {
    return flashbvh::tool::fail(error.what());
  }
}
