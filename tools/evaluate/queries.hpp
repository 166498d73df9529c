// Queries on images: pairs and distances.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/traversal/traversals.hpp"
#include "image/image_file.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// The traversal of two meshes in this layout.
constexpr const char* traversal_of(Layout layout) {
  return layout == Layout::post_indexed ? "ranked" : "stackless";
}

/// True if one query accepts both: trees of one kind, lattices of one cell.
bool are_partners(const ImageFile& a, const ImageFile& b);

/// UserError with a remedy unless the images are partners.
void check_partners(const ImageFile& a, const ImageFile& b);

/// Two triangles, by their numbers in the source files.
struct FoundPair {
  std::uint32_t a;
  std::uint32_t b;
};

/// Like flashbvh::QueryStats, but wide enough for any two meshes.
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
  std::vector<FoundPair> pairs;  ///< in the order of the query's reports
  std::optional<bool> inside;    ///< if there are no pairs: one mesh is inside the other, if known
};

/// Runs the library's query to its end, or to the first pair. Both trees are of one kind.
Answer collide(const AnyTree& a, const AnyTree& b, const Pose& pose, bool only_first);

/// UserError, naming `place` and the pose by its number, if the query ended with an error.
void check_answered(const Answer& answer, const std::string& place, std::size_t pose);

/// The distance of two triangles, in cells of A's frame in the source file.
struct NearestPair {
  FoundPair triangles;
  double distance;  ///< to the nearest double
  NearestPoints points;
};

struct ClearanceAnswer {
  Status status = Status::done;
  bool in_range = true;              ///< false: only both bounds of the distance are known
  std::uint32_t lower = 0;           ///< of the distance, in 1/256 cell
  std::uint32_t upper = UINT32_MAX;  ///< UINT32_MAX: this or more
  std::optional<NearestPair> nearest;
  std::uint64_t visits = 0;
  std::uint64_t triangle_pairs = 0;  ///< number of tests
};

/// UserError with a remedy if `image` is pre-indexed: distance queries walk post-indexed trees.
void check_has_clearance(const ImageFile& image);

/// As fine_length_rounded_up(). UserError, naming --within, if it is not a number from 0 to `most`.
FineLength fine_length(double length, double cell, std::uint32_t most);

/// The distance at a pose. The last pose's nearest pair is the hint, and `hint` is updated. Both
/// trees are of one kind, post-indexed.
ClearanceAnswer clearance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                          Witness<std::uint32_t>& hint);

/// Runs flashbvh::one_is_inside() for two meshes without intersecting triangles; nothing if one
/// mesh is not closed, or pre-indexed.
std::optional<bool> one_is_inside(const ImageFile& a, const ImageFile& b, const Pose& pose);

/// Calls `query(meshes...)`, with meshes as in firmware's queries, for post-indexed trees of one
/// kind; else returns nothing.
template <class Found, class Query, class... Others>
std::optional<Found> query_post(const Query& query, const AnyTree& any, const Others&... others) {
  return std::visit(
      [&](const auto& tree) -> std::optional<Found> {
        using Tree = std::decay_t<decltype(tree)>;
        if constexpr (Tree::kLayout == Layout::post_indexed) {
          using Plain = BasicMesh<typename Tree::Index, Layout::post_indexed>;
          return query(static_cast<const Plain&>(tree),
                       static_cast<const Plain&>(std::get<Tree>(others))...);
        } else {
          return std::nullopt;
        }
      },
      any);
}

/// Calls query(mesh); UserError if the image is pre-indexed.
template <class Found, class Query>
Found query_post_mesh(const ImageFile& image, const Query& query) {
  std::optional<Found> found = query_post<Found>(query, image.tree());
  if (!found) {
    throw UserError(
        image.path(),
        "is pre-indexed, which this question does not take; bake it with --layout post");
  }
  return *std::move(found);
}

}  // namespace flashbvh::tool
