// flashbvh help [COMMAND]: prints the output of --help.
#include <iostream>

#include "cli/commands.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct HelpArguments {
  std::string command;
};

}  // namespace

void add_help(CLI::App& app) {
  auto [command, a] = add_command<HelpArguments>(
      app, "help", "Print the program's help, or a command's.", [&app](const HelpArguments& given) {
        const CLI::App* const of = given.command.empty() ? &app : app.get_subcommand(given.command);
        const std::string name = given.command.empty() ? "" : " " + given.command;
        std::cout << of->get_formatter()->make_help(of, "flashbvh" + name,
                                                    CLI::AppFormatMode::Normal);
      });
  command.add_option("COMMAND", a.command, "A command of the program")
      ->check([&app](const std::string& name) { return unknown_command(app, name); },
              "{" + joined(command_names(app), ",") + "}");
  add_example(command, "help bake", "prints the options of bake, and an example");
}

}  // namespace flashbvh::tool
