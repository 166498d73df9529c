// flashbvh: bakes meshes and robots; inspects, checks, exports and queries their images.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "cli/commands.hpp"
#include "flashbvh/version.hpp"
#include "text/messages.hpp"
#include "text/nearest.hpp"

namespace flashbvh::tool {
namespace {

#define FLASHBVH_TEXT_OF(value) #value
#define FLASHBVH_TEXT(value) FLASHBVH_TEXT_OF(value)
constexpr const char* kVersion =
    "flashbvh " FLASHBVH_TEXT(FLASHBVH_VERSION_MAJOR) "." FLASHBVH_TEXT(
        FLASHBVH_VERSION_MINOR) "." FLASHBVH_TEXT(FLASHBVH_VERSION_PATCH);

int fail(const std::string& message) {
  std::cerr << "flashbvh: " << one_line(message) << "\n";
  return kBadInput;
}

/// "there is no option '--formt'; the nearest is '--format'", for the first argument that looks
/// like an option but is none of the command's; empty if there is no such argument.
std::string unknown_option(const CLI::App& command) {
  const auto rest = command.remaining();
  const auto first = std::find_if(rest.begin(), rest.end(),
                                  [](const std::string& argument) { return argument[0] == '-'; });
  if (first == rest.end() || *first == "--") {  // positional arguments follow
    return "";
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    names.insert(names.end(), option->get_lnames().begin(), option->get_lnames().end());
  }
  const std::string given = first->substr(0, first->find('='));
  const std::string name = given.substr(std::min(given.find_first_not_of('-'), given.size()));
  return "there is no option '" + given + "'" + nearest_hint(name, names, "--");
}

/// Prints the error of a command line, and the command that shows the help.
int fail(const CLI::ParseError& error, const CLI::App& app) {
  const auto given = app.get_subcommands();
  const std::string command = given.empty() ? "flashbvh" : "flashbvh " + given[0]->get_name();
  const std::string unknown = unknown_option(given.empty() ? app : *given[0]);
  return fail((unknown.empty() ? error.what() : unknown) + "; see " + command + " --help");
}

int run(int argc, char** argv) {
  CLI::App app("Bounding volume trees for microcontrollers: bakes meshes, looks at what it baked.",
               "flashbvh");
  app.require_subcommand(0, 1);            // after a command, the name of another is an argument
  app.allow_windows_style_options(false);  // "/part.stl" is a file on every system
  app.set_version_flag("--version", kVersion);
  add_bake(app);
  add_info(app);
  add_check(app);
  add_export(app);
  add_report(app);
  add_collide(app);
  add_clearance(app);
  add_motion(app);
  add_inside(app);
  add_ray(app);
  add_bench(app);
  add_robot(app);
  add_guard(app);
  add_audit(app);
  add_help(app);
  add_example(app, "help bake", "prints the options of bake, and an example");
  if (argc < 2) {
    return fail("a command is missing; see flashbvh --help");
  }
  if (argv[1][0] != '-') {
    const std::string wrong = unknown_command(app, argv[1]);
    if (!wrong.empty()) {
      return fail(wrong + "; see flashbvh --help");
    }
  }
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
