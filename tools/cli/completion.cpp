// flashbvh completion SHELL: prints a script that completes commands, options and their values in a
// shell. The script is made from the program's commands.
#include <algorithm>
#include <iostream>

#include "cli/commands.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A shell's script, and its code to complete a value: a word of a set, a folder, a file with an
/// ending, any file, or any other value. % stands for the set, separated by blanks, or the ending.
struct Shell {
  const char* name;
  void (*print)(const Shell& shell, const CLI::App& app);
  const char *word, *folder, *ending, *file, *other;
};

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// The name of a value in the help, such as "LENGTH".
std::string label_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::string with(std::string action, const std::string& value) {
  const std::size_t place = action.find('%');
  return place == std::string::npos ? action : action.replace(place, 1, value);
}

/// The value's name in the help selects the code: KIND:{c,image} is a set, FILE and PAGE.html
/// files.
std::string action_of(const CLI::Option& option, const Shell& shell) {
  std::string set = option.get_type_name();
  constexpr std::string_view kBraces = "{}";
  const std::size_t begin = set.find(kBraces[0]);
  if (begin != std::string::npos) {
    std::replace(set.begin(), set.end(), ',', ' ');
    return with(shell.word, set.substr(begin + 1, set.find(kBraces[1]) - begin - 1));
  }
  const std::string label = label_of(option);
  const std::size_t dot = label.find('.');
  return dot != std::string::npos ? with(shell.ending, label.substr(dot))
         : label == "FILE"        ? shell.file
         : label == "DIR"         ? shell.folder
                                  : shell.other;
}

std::string escaped(const std::string& text, const std::string& what) {
  std::string result;
  for (const char letter : text) {
    result += what.find(letter) == std::string::npos ? "" : "\\";
    result += letter;
  }
  return result;
}

/// The beginning of a help text, up to the first end of a clause, as one line.
std::string summary(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (const char* end : {". ", "; ", ": "}) {
    text = text.substr(0, text.find(end));
  }
  return text.substr(0, text.find_last_not_of(" .") + 1);
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) {
    names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  return names;
}

/// One name of each option of the command, in one line.
std::string options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->nonpositional()) {
      names.push_back(option->get_name());
    }
  }
  return joined(names, " ");
}

constexpr const char* kBashHead = R"(_flashbvh() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words= files=
  # Readline takes --format=c as three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case "$COMP_CWORD ${COMP_WORDS[1]} $before" in
)";
constexpr const char* kBashTail = R"(  esac
  if [[ $files ]]; then
    compopt -o filenames
    mapfile -t COMPREPLY < <(compgen -f -X "!$files" -- "$current"; compgen -d -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}
complete -F _flashbvh flashbvh
)";

/// Prints a case for each option with a value, then one for all other words. If positional
/// arguments differ, the first one counts.
void print_bash_cases(const Shell& shell, const CLI::App& command) {
  const std::string name = "*' " + command.get_name() + " ";
  std::string positional = shell.other;
  for (const CLI::Option* option : command.get_options()) {
    const std::string action = action_of(*option, shell);
    if (option->get_positional()) {
      positional = positional == shell.other ? action : positional;
    } else if (takes_value(*option)) {
      std::cout << "  " << name << joined(names_of(*option), ("'|" + name).c_str()) << "') "
                << action << " ;;\n";
    }
  }
  std::cout << "  " << name << "'*) [[ $current == -* ]] && words='" << options_of(command)
            << "' || " << positional << " ;;\n";
}

void print_bash(const Shell& shell, const CLI::App& app) {
  std::cout << kBashHead << "  '1 '*) words='" << options_of(app) << " "
            << joined(command_names(app), " ") << "' ;;\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    print_bash_cases(shell, *command);
  }
  std::cout << kBashTail;
}

/// Escapes text for a part of a word $'like this' that _arguments and _describe read.
std::string in_zsh(const std::string& text) {
  return escaped(escaped(text, "[]:\\"), "'\\");
}

/// Prints a specification for _arguments. Each option may be repeated.
void print_zsh_argument(const Shell& shell, const CLI::Option& option) {
  const bool has_value = takes_value(option);
  const std::string label = option.get_positional() ? option.get_name(true) : label_of(option);
  const std::string value = ":" + in_zsh(label) + ":" + action_of(option, shell);
  if (option.get_positional()) {
    const bool is_repeated = option.get_items_expected_max() > 1;
    std::cout << " \\\n    $'" << (is_repeated ? "*" : "") << value << "'";
  }
  for (const std::string& name : names_of(option)) {
    const char* const before_value = !has_value ? "" : name[1] == '-' ? "=" : "+";
    std::cout << " \\\n    $'*" << name << before_value << "["
              << in_zsh(summary(option.get_description())) << "]" << (has_value ? value : "")
              << "'";
  }
}

constexpr const char* kZshTail = R"(  esac
}
if [[ $funcstack[1] == _flashbvh ]]; then  # loaded from $fpath
  _flashbvh "$@"
else
  compdef _flashbvh flashbvh
fi
)";

void print_zsh(const Shell& shell, const CLI::App& app) {
  std::cout << "#compdef flashbvh\n_flashbvh() {\n  local -a commands=(\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    std::cout << "    $'" << command->get_name() << ":"
              << in_zsh(summary(command->get_description())) << "'\n";
  }
  std::cout << "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n"
            << "    compadd -- " << options_of(app) << "\n    return\n  fi\n"
            << "  shift words\n  (( CURRENT-- ))\n  case $words[1] in\n";
  for (const CLI::App* command : app.get_subcommands({})) {
    std::cout << "  " << command->get_name() << ") _arguments";
    for (const CLI::Option* option : command->get_options()) {
      print_zsh_argument(shell, *option);
    }
    std::cout << " ;;\n";
  }
  std::cout << kZshTail;
}

std::string in_fish(const std::string& text) {
  return "'" + escaped(text, "'\\") + "'";
}

void print_fish_options(const Shell& shell, const CLI::App& command, const std::string& condition) {
  for (const CLI::Option* option : command.get_options()) {
    std::cout << "complete -c flashbvh -n " << condition;
    for (const std::string& name : names_of(*option)) {
      std::cout << (name[1] == '-' ? " -l " + name.substr(2) : " -s " + name.substr(1));
    }
    std::cout << (takes_value(*option) ? " " + action_of(*option, shell) : "") << " -d "
              << in_fish(summary(option->get_description())) << "\n";
  }
}

void print_fish(const Shell& shell, const CLI::App& app) {
  std::cout << "complete -c flashbvh -f\n";
  print_fish_options(shell, app, "__fish_use_subcommand");
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string name = command->get_name();
    std::cout << "complete -c flashbvh -n __fish_use_subcommand -a " << name << " -d "
              << in_fish(summary(command->get_description())) << "\n";
    print_fish_options(shell, *command, "'contains " + name + " (commandline -opc)[2]'");
  }
}

constexpr Shell kShells[] = {
    {"bash", print_bash, "words='%'", "files=/", "files='*%'", "files='*'", ":"},
    {"zsh", print_zsh, "(%)", "_files -/", "_files -g \"*%\"", "_files", " "},
    {"fish", print_fish, "-x -a '%'", "-x -a '(__fish_complete_directories)'",
     "-r -k -a '(__fish_complete_suffix %)'", "-r -F", "-x"},
};

struct CompletionArguments {
  std::string shell;
};

}  // namespace

void add_completion(CLI::App& app) {
  std::vector<std::string> names;
  for (const Shell& shell : kShells) {
    names.emplace_back(shell.name);
  }
  auto [command, a] = add_command<CompletionArguments>(
      app, "completion",
      "Print a script by which a shell completes commands, options, their values and files.",
      [&app](const CompletionArguments& given) {
        for (const Shell& shell : kShells) {
          if (shell.name == given.shell) {
            shell.print(shell, app);
          }
        }
      });
  command.add_option("SHELL", a.shell, "The shell")->required()->check(CLI::IsMember(names));
  add_example(command, "completion bash",
              "prints the script; eval \"$(flashbvh completion bash)\" loads it");
}

}  // namespace flashbvh::tool
