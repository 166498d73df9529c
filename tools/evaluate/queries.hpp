// Queries on images: pairs by the name of a traversal, and distances.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "reference/traversals.hpp"
#include "text/messages.hpp"

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

/// Of two triangles, in cells of A's frame as it was drawn.
struct NearestPair {
  FoundPair triangles;
  double distance;  ///< to the nearest double
  NearestPoints points;
};

struct ClearanceAnswer {
  Status status = Status::done;
  bool in_range = true;              ///< false: of the distance only both bounds are known
  std::uint32_t lower = 0;           ///< of a distance, in 1/256 cell
  std::uint32_t upper = UINT32_MAX;  ///< UINT32_MAX: so much or more
  std::vector<NearestPair> nearest;  ///< one, or none; within a distance: all, sorted
  std::uint64_t visits = 0;
  std::uint64_t triangle_pairs = 0;  ///< tested
};

/// UserError, with the remedy, if `image` is pre-indexed: distances walk post-indexed trees.
void check_has_clearance(const ImageFile& image);

enum class Rounding : std::uint8_t { downwards, upwards };

/// A length in 1/256 cell; what is a whole number but for a double's rounding is it. UserError,
/// naming `what`, if it is no number from 0 to `most`.
std::uint32_t fine_length(double length, double cell, std::uint32_t most, Rounding rounding,
                          const std::string& what = "--within");

/// The distance, for each pose with the nearest pair before as its hint: `hint` is changed. Both
/// trees are of one kind, post-indexed.
ClearanceAnswer clearance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                          Witness<std::uint32_t>& hint);

/// Pairs within a distance, in 1/256 cell; only the first if not `all`.
ClearanceAnswer within_distance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                                std::uint32_t distance, bool all);

/// Of two meshes whose triangles do not intersect, by flashbvh::one_is_inside(); nothing if one is
/// not closed, or pre-indexed.
std::optional<bool> one_is_inside(const ImageFile& a, const ImageFile& b, const Pose& pose);

/// `ask(meshes...)` as firmware's queries take them, of post-indexed trees of one kind; else
/// nothing.
template <class Found, class Ask, class... Others>
std::optional<Found> ask_post(const Ask& ask, const AnyTree& any, const Others&... others) {
  return std::visit(
      [&](const auto& tree) -> std::optional<Found> {
        using Tree = std::decay_t<decltype(tree)>;
        if constexpr (Tree::kLayout == Layout::post_indexed) {
          using Plain = BasicMesh<typename Tree::Index, Layout::post_indexed>;
          return ask(static_cast<const Plain&>(tree),
                     static_cast<const Plain&>(std::get<Tree>(others))...);
        } else {
          return std::nullopt;
        }
      },
      any);
}

/// query(mesh); UserError if the image is pre-indexed.
template <class Found, class Query>
Found query_post_mesh(const ImageFile& image, const Query& query) {
  std::optional<Found> found = ask_post<Found>(query, image.tree());
  if (!found) {
    throw UserError(
        image.path(),
        "is pre-indexed, which this question does not take; bake it with --layout post");
  }
  return *std::move(found);
}

}  // namespace flashbvh::tool
