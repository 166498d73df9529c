// What the program says on standard error: one line that says what the user must fix, with exit
// code 2, and warnings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "text/numbers.hpp"

namespace flashbvh::tool {

/// Thrown wherever an input can't be used; main() prints it and exits with 2.
class UserError : public std::runtime_error {
 public:
  /// `place`: a file, or an option. `what`: what is wrong there, and the remedy, on one line.
  template <class... Parts>
  explicit UserError(const std::string& place, const Parts&... what)
      : std::runtime_error(concat(place, ": ", what...)) {}
};

/// Without line ends and other control characters, whatever a file's name or a library's message
/// holds.
std::string one_line(std::string text);

/// "3 triangles (1, 5 and 8)" or "912 triangles (1, 5, 8, 9, 10 and 907 more)"; numbers count from
/// 0.
std::string triangle_list(const std::vector<std::uint32_t>& triangles);

/// A place for UserError: a line of a text file, counted from 1.
std::string at_line(const std::string& file, std::size_t line);

/// A word of a file, cut where it is long.
std::string quoted(std::string_view word);

/// A word as a finite number; else UserError, with `more` at its end.
double number_of(std::string_view word, const std::string& place, const char* more = "");

/// Writes what standard output still holds back; throws if it does not take it.
void flush_output();

struct PlacedWarning {
  std::string place;
  std::string what;
};

/// Collected while a progress bar may stand on the line, printed when it is gone.
class Warnings {
 public:
  void add(const std::string& place, const std::string& what);
  /// One line each on standard error.
  void print() const;
  const std::vector<PlacedWarning>& all() const { return all_; }

 private:
  std::vector<PlacedWarning> all_;
};

}  // namespace flashbvh::tool
