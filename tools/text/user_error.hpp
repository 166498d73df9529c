// What the user must mend: the one line on standard error behind exit code 2.
#ifndef FLASHBVH_TOOLS_TEXT_USER_ERROR_HPP
#define FLASHBVH_TOOLS_TEXT_USER_ERROR_HPP

#include <cstddef>
#include <stdexcept>
#include <string>

namespace flashbvh::tool {

/// Thrown wherever an input can't be used; main() prints it and exits with 2.
class UserError : public std::runtime_error {
 public:
  /// `place`: a file, or an option. `what`: what is wrong there, and the mend, on one line.
  UserError(const std::string& place, const std::string& what)
      : std::runtime_error(place + ": " + what) {}

  /// At a line of a text file, counted from 1.
  UserError(const std::string& file, std::size_t line, const std::string& what)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + what) {}
};

}  // namespace flashbvh::tool

#endif
