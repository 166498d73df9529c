// flashbvh: bakes meshes and robots; inspects, checks, exports and queries their images.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "cli/commands.hpp"
#include "flashbvh/version.hpp"
#include "text/messages.hpp"

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

bool is_command(CLI::App& app, const std::string& name) {
  const auto commands = app.get_subcommands([](CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* command) { return command->get_name() == name; });
}

/// What is wrong with a command line, and where the help is.
int fail(const CLI::ParseError& error, const CLI::App& app) {
  const auto given = app.get_subcommands();
  const std::string command = given.empty() ? "flashbvh" : "flashbvh " + given[0]->get_name();
  return fail(std::string(error.what()) + "; see " + command + " --help");
}

int run(int argc, char** argv) {
  CLI::App app("Bounding volume trees for microcontrollers: bakes meshes, looks at what it baked.",
               "flashbvh");
  ExitCode exit_code = kSuccess;
  app.set_version_flag("--version", kVersion);
  add_bake(app);
  add_info(app);
  add_check(app, exit_code);
  add_export(app);
  add_report(app);
  add_collide(app);
  add_clearance(app);
  add_inside(app);
  add_ray(app);
  add_bench(app, exit_code);
  add_robot(app);
  add_guard(app, exit_code);
  add_audit(app, exit_code);
  if (argc < 2) {
    return fail("a command is missing; see flashbvh --help");
  }
  if (argv[1][0] != '-' && !is_command(app, argv[1])) {
    return fail("there is no command '" + std::string(argv[1]) + "'; see flashbvh --help");
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) {
      return fail(error, app);
    }
    app.exit(error);  // --help and --version
    flush_output();
    return kSuccess;
  }
  if (app.get_subcommands().empty()) {
    return fail("a command is missing; see flashbvh --help");
  }
  flush_output();
  return exit_code;
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
