// What queries cost: visits over a sample of poses, by how close the meshes come.
#ifndef FLASHBVH_TOOLS_REPORT_VISITS_HPP
#define FLASHBVH_TOOLS_REPORT_VISITS_HPP

#include <array>
#include <cstdint>

#include "image/image_file.hpp"

namespace flashbvh::tool {

/// Told by the answer.
enum Closeness : std::uint8_t {
  kSeparated,       ///< the boxes of the roots are disjoint
  kSmallProximity,  ///< no pair of leaves overlaps
  kCloseProximity,  ///< no pair of triangles intersects
  kIntersecting,    ///< some pair does
  kClosenessCount,
};

struct Visits {
  std::uint64_t poses = 0;
  std::uint64_t sum = 0;
  std::uint64_t most = 0;
};

struct VisitSample {
  std::array<Visits, kClosenessCount> all;  ///< queries that find every pair
  Visits first;                             ///< intersecting poses again, up to the first pair
  std::uint64_t out_of_range = 0;  ///< poses that can't be: a mesh lies too far from its origin
  bool costly = false;             ///< kMostVisits were reached
};

/// Random poses for each that is wanted of a class.
constexpr std::uint64_t kTries = 20;
/// Visits at which one sample stops.
constexpr std::uint64_t kMostVisits = 50'000'000;

/// The first `wanted` poses of each class among kTries * `wanted`. By the default algorithm of the
/// images' layout. Precondition: both of one kind and cell.
VisitSample sample_visits(const ImageFile& a, const ImageFile& b, std::uint64_t wanted);

}  // namespace flashbvh::tool

#endif
