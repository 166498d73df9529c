// The subcommands. Each function declares one: its options, and what runs when it is given.
#ifndef FLASHBVH_TOOLS_CLI_COMMANDS_HPP
#define FLASHBVH_TOOLS_CLI_COMMANDS_HPP

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace flashbvh::tool {

/// What the program returns; 2 is for UserError.
enum ExitCode : int { kSuccess = 0, kCheckFailed = 1, kBadInput = 2, kRefusedValues = 3 };

/// `exit_code` is set when the command ran; it must outlive the parsing.
void add_bake(CLI::App& app);
void add_info(CLI::App& app);
void add_check(CLI::App& app, ExitCode& exit_code);
void add_export(CLI::App& app);
void add_report(CLI::App& app);
void add_collide(CLI::App& app);
void add_clearance(CLI::App& app);
void add_inside(CLI::App& app);
void add_ray(CLI::App& app);
void add_bench(CLI::App& app, ExitCode& exit_code);
void add_robot(CLI::App& app);
void add_guard(CLI::App& app, ExitCode& exit_code);

/// Declares a command that calls run(arguments); its options go to the arguments.
template <class Arguments, class Run>
std::pair<CLI::App&, Arguments&> add_command(CLI::App& app, const char* name, const char* what,
                                             const Run& run) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand(name, what);
  command->callback([arguments, run] { run(*arguments); });
  return {*command, *arguments};
}

/// Declares --unit, which can be given several times and takes one word each time.
void add_unit_option(CLI::App& command, std::vector<std::string>& given);

}  // namespace flashbvh::tool

#endif
