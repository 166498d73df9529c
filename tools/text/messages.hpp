// Messages on standard error: one line with the error and its fix, with exit code 2; and warnings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "text/numbers.hpp"

namespace flashbvh::tool {

/// Thrown if an input can't be used; main() prints it and exits with 2.
class UserError : public std::runtime_error {
 public:
  /// `place`: a file, or an option. `what`: the error and its remedy, on one line.
  template <class... Parts>
  explicit UserError(const std::string& place, const Parts&... what)
      : std::runtime_error(concat(place, ": ", what...)) {}
};

/// Replaces line ends and other control characters, which names of files and messages of libraries
/// may contain.
std::string one_line(std::string text);

/// "3 triangles (1, 5 and 8)" or "912 triangles (1, 5, 8, 9, 10 and 907 more)"; numbers count from
/// 0.
std::string triangle_list(const std::vector<std::uint32_t>& triangles);

/// A place for UserError: a line of a text file, numbered from 1.
std::string at_line(const std::string& file, std::size_t line);

/// A word of a file; long words are cut.
std::string quoted(std::string_view word);

/// The word as a finite number; else UserError, with `more` at the end of its message.
double number_of(std::string_view word, const std::string& place, const char* more = "");

/// Flushes standard output; throws on failure.
void flush_output();

struct PlacedWarning {
  std::string place;
  std::string what;
};

/// Collects warnings while a progress bar may be visible, and prints them afterwards.
class Warnings {
 public:
  void add(const std::string& place, const std::string& what);
  /// Prints one line per warning on standard error.
  void print() const;
  const std::vector<PlacedWarning>& all() const { return all_; }

 private:
  std::vector<PlacedWarning> all_;
};

}  // namespace flashbvh::tool
