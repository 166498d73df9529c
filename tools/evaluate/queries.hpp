// Queries on images by the name of their traversal.
#ifndef FLASHBVH_TOOLS_EVALUATE_QUERIES_HPP
#define FLASHBVH_TOOLS_EVALUATE_QUERIES_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "flashbvh/contact.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "reference/traversals.hpp"

namespace flashbvh::tool {

/// All names, the default of post-indexed images first.
std::vector<std::string> traversal_names();

/// Whether the traversal walks trees of this layout.
bool walks(const std::string& traversal, Layout layout);

/// Whether a query can take the two: trees of one kind, lattices of one cell.
bool are_partners(const ImageFile& a, const ImageFile& b);

/// UserError, with the remedy, unless they are partners.
void check_partners(const ImageFile& a, const ImageFile& b);

/// Triangles by their numbers in the source files.
struct FoundPair {
  std::uint32_t a;
  std::uint32_t b;
};

/// As flashbvh::QueryStats, but wide enough for any two meshes.
struct WideCounts {
  std::uint64_t visits = 0;
  std::uint64_t overlaps = 0;
  std::uint64_t leaf_pairs = 0;
  std::uint64_t triangle_pairs = 0;
};

struct Answer {
  Status status = Status::done;  ///< `done` or an error
  WideCounts counts;
  std::uint64_t work = 0;
  std::vector<FoundPair> pairs;   ///< in the order in which the query reports them
  std::vector<Contact> contacts;  ///< of each pair, if requested
  std::optional<bool> inside;     ///< without pairs: whether one mesh is inside the other, if known
};

/// What a query returns in addition to counts and pairs.
struct Asked {
  bool first = false;  ///< to end at the first pair
  bool contacts = false;
};

/// Runs the library's query to its end, or to the first pair.
/// Precondition: both trees are of one kind, and walks(traversal, their layout).
Answer collide(const AnyTree& a, const AnyTree& b, const Pose& pose, const std::string& traversal,
               const Asked& asked);

/// UserError, naming `place` and the pose by its number, if the query ended with an error.
void check_answered(const Answer& answer, const std::string& place, std::size_t pose);

}  // namespace flashbvh::tool

#endif
