// Options that several commands declare alike.
#ifndef FLASHBVH_TOOLS_CLI_OPTIONS_HPP
#define FLASHBVH_TOOLS_CLI_OPTIONS_HPP

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// `type`: the value's name in the help, as "FILE".
template <class Value>
CLI::Option* add_option(CLI::App& command, const char* name, Value& to, const char* type,
                        const std::string& what) {
  return command.add_option(name, to, what)->type_name(type);
}

/// One of `words`; the help shows the default.
inline CLI::Option* add_choice(CLI::App& command, const char* name, std::string& to,
                               const std::vector<std::string>& words, const std::string& what) {
  return command.add_option(name, to, what)->check(CLI::IsMember(words))->capture_default_str();
}

/// Makes an option of a vector one that is given once for each element.
inline CLI::Option* repeated(CLI::Option* option) {
  return option->type_size(1)->expected(1)->allow_extra_args(false)->multi_option_policy(
      CLI::MultiOptionPolicy::TakeAll);
}

/// Declares IMAGE; `to`: a path, or several.
template <class Paths>
void add_image(CLI::App& command, Paths& to, const char* what = "Image (.fbvh)") {
  command.add_option("IMAGE", to, what)->required();
}

inline void add_json(CLI::App& command, bool& to, const char* what) {
  command.add_flag("--json", to, what);
}

inline void add_progress(CLI::App& command, bool& to) {
  command.add_flag("--progress", to,
                   "Show a progress bar at once; default: on a terminal, after a second");
}

}  // namespace flashbvh::tool

#endif
