// The subcommands, their shared options, and checks that protect input files.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "text/numbers.hpp"

namespace flashbvh::tool {

/// "flashbvh 1.2.3".
std::string version_text();

/// For commands that write no image: UserError if the file `output` is one of `inputs`, under any
/// name, or if it is an image. An empty `output` means no file.
void check_output(const std::string& output, const std::vector<std::string>& inputs);

struct PosedImages {
  std::string a;
  std::string b;
  std::string poses;
};

/// Declares A, B and --poses, which it returns.
CLI::Option* add_posed_images(CLI::App& command, PosedImages& to);

/// Ends the command's help. `line`: the arguments after `flashbvh` in a working command line;
/// `what` it prints or makes, in a few words.
void add_example(CLI::App& command, const std::string& line, const std::string& what);

/// `type`: the value's name in the help, such as "FILE".
template <class Value>
CLI::Option* add_option(CLI::App& command, const char* name, Value& to, const char* type,
                        const std::string& what) {
  return command.add_option(name, to, what)->type_name(type);
}

/// Declares an option with one of `words` as its value; the help shows the default.
inline CLI::Option* add_choice(CLI::App& command, const char* name, std::string& to,
                               const std::vector<std::string>& words, const std::string& what) {
  return command.add_option(name, to, what)->check(CLI::IsMember(words))->capture_default_str();
}

/// Makes a vector's option one that the user gives once per element.
inline CLI::Option* repeated(CLI::Option* option) {
  return option->type_size(1)->expected(1)->allow_extra_args(false)->multi_option_policy(
      CLI::MultiOptionPolicy::TakeAll);
}

/// The program's exit code; 2 is for UserError.
enum ExitCode : int { kSuccess = 0, kCheckFailed = 1, kBadInput = 2, kRefusedValues = 3 };

/// Parsing runs the command; CLI::RuntimeError has its exit code unless that is kSuccess.
using AddCommand = void(CLI::App& app);
AddCommand add_bake, add_info, add_report, add_collide, add_clearance, add_motion, add_inside,
    add_ray, add_bench, add_robot, add_guard, add_audit;

/// Declares a command that calls run(arguments), which returns an ExitCode or nothing; the options
/// fill the arguments.
template <class Arguments, class Run>
std::pair<CLI::App&, Arguments&> add_command(CLI::App& app, const char* name, const char* what,
                                             const Run& run) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand(name, what);
  command->callback([arguments, run] {
    if constexpr (std::is_void_v<decltype(run(*arguments))>) {
      run(*arguments);
    } else if (const ExitCode code = run(*arguments); code != kSuccess) {
      throw CLI::RuntimeError(code);
    }
  });
  return {*command, *arguments};
}

/// Declares --unit, which may be repeated and takes one word each time.
void add_unit_option(CLI::App& command, std::vector<std::string>& given);

}  // namespace flashbvh::tool
