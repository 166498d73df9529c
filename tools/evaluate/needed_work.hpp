// What queries at some poses needed, what a core can take for it at most, and the most that any
// pose can take: if all boxes overlap.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// The work that queries at some poses needed.
struct NeededWork {
  std::uint64_t most = 0;
  std::uint64_t percentile_99 = 0;  ///< 99 of 100 needed no more
  double mean = 0;
};

/// Precondition: not empty.
NeededWork needed_work(std::vector<std::uint64_t> work);

/// What a baked header has as NAME_TREE_SIZE.
TreeSize tree_size(const ImageHeader& header);

/// A core by its name in the documents, and what is proven of it.
struct Core {
  const char* name;
  RunCosts costs;
  std::optional<RunCycles> cycles = {};
};

/// Those of time_bound.hpp.
#define FLASHBVH_CORE_OF(core, c_name, text, ...) {text, k##core},
inline constexpr Core kCores[] = {FLASHBVH_FOR_EACH_CORE(FLASHBVH_CORE_OF)};
#undef FLASHBVH_CORE_OF

/// Those, with cycles where they are proven, after cores that differ from one of them in cycles.
std::vector<Core> cores_in_cycles();

struct VisitBound {
  std::uint64_t visits = 0;
  std::uint64_t leaf_pairs = 0;      ///< of the visits
  std::uint64_t triangle_pairs = 0;  ///< that are tested at these
  std::uint64_t work = 0;
};

/// Attained where all boxes overlap: exact for `ranked` and `ranked-stack`; for the others, which
/// follow other orders, at most twice what they visit then if no node has a single child.
/// Precondition: both trees are of one kind, and walks(algorithm, their layout). O(nodes).
VisitBound visit_bound(const AnyTree& a, const AnyTree& b, const std::string& algorithm);

}  // namespace flashbvh::tool
