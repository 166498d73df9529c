// --simplify and --fit of meshes and robots; the table of the sizes that they reach, one row per
// length.
#pragma once

#include <string>
#include <vector>

#include "cli/json.hpp"
#include "image/baking.hpp"
#include "simplify/fit.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// UserError if both options are given.
inline void check_simplify_or_fit(bool simplify, bool fit) {
  if (simplify && fit) {
    throw UserError("--fit", "chooses what --simplify says; give one of the two");
  }
}

/// The value of an option that limits images' sizes. UserError unless it is from 1 to 2^32 - 1.
std::int64_t bytes_of(const std::string& option, const std::string& text);

/// The leaf sizes of the table's columns. `has_leaf_size`: the user chose `leaf_size`.
inline std::vector<std::uint32_t> shown_leaf_sizes(std::uint32_t leaf_size, bool has_leaf_size) {
  return has_leaf_size || leaf_size >= kLargeLeaf
             ? std::vector<std::uint32_t>{leaf_size}
             : std::vector<std::uint32_t>{leaf_size, kLargeLeaf};
}

struct LengthTable {
  std::vector<simplify::LengthRow> rows;
  std::vector<std::uint32_t> leaf_sizes;  ///< of the columns
};

/// Prints to standard output.
void print_lengths(const LengthTable& table, const std::string& unit);
Json json_of(const LengthTable& table);

}  // namespace flashbvh::tool
