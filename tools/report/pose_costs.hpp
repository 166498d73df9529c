// What queries about two images cost: work at given poses, or at random ones.
#ifndef FLASHBVH_TOOLS_REPORT_POSE_COSTS_HPP
#define FLASHBVH_TOOLS_REPORT_POSE_COSTS_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "evaluate/needed_work.hpp"
#include "evaluate/visit_bound.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// By the answer of a query.
enum Closeness : std::uint8_t {
  kSeparated,       ///< the boxes of the roots are disjoint
  kSmallProximity,  ///< no pair of leaves overlaps
  kCloseProximity,  ///< no pair of triangles intersects
  kIntersecting,    ///< some pair does
  kClosenessCount,
};

struct PoseCost {
  Pose pose;
  Closeness closeness;
  std::uint64_t work;            ///< of a query that finds every pair
  std::uint64_t work_to_first;   ///< of one that stops at the first pair
  std::uint64_t triangle_pairs;  ///< that intersect
};

struct PairCosts {
  VisitBound bound;                ///< of any pose
  std::vector<PoseCost> poses;     ///< none with --samples 0
  NeededWork needed;               ///< at these, for every pair of triangles
  NeededWork needed_to_first;      ///< for the first pair
  std::uint64_t out_of_range = 0;  ///< poses that can't be: a mesh lies too far from its origin
  bool costly = false;             ///< kMostVisits were reached
};

/// Visits at which one sample stops.
constexpr std::uint64_t kMostVisits = 50'000'000;

/// By the default algorithm of the images' layout, at the poses of a file as `collide` takes them.
/// UserError as read_lattice_poses(), or if a query is refused. Precondition: are_partners(a, b).
PairCosts costs_at(const ImageFile& a, const ImageFile& b, const std::string& path);

/// At so many random poses, always the same for the same images: B rotated by any rotation, each as
/// likely as the other, the middle of its box in any direction from the middle of A's, at any
/// distance up to the sum of half their diagonals.
PairCosts sampled_costs(const ImageFile& a, const ImageFile& b, std::size_t count);

}  // namespace flashbvh::tool

#endif
