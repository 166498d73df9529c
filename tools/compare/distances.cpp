// Compares distances of meshes that do not intersect.
#include <algorithm>
#include <cstdio>

#include "comparison.hpp"
#include "flashbvh/clearance.hpp"

using namespace figures;

namespace compare {
namespace {

constexpr Proximity kApart[] = {Proximity::separated, Proximity::small, Proximity::close};
/// For double precision: a larger relative error counts as a difference.
constexpr double kTolerance = 1e-6;

struct Named {
  const char* name;
  std::unique_ptr<DistanceMeter> library;
};

std::vector<Named> all_libraries(const flashbvh::Mesh& a, const flashbvh::Mesh& b) {
  std::vector<Named> all;
  all.push_back({"distance", distances_of_flashbvh(a, b, Hint::none)});
  all.push_back({"distance_hinted", distances_of_flashbvh(a, b, Hint::last_pose)});
  all.push_back({"distance_fcl", distances_of_fcl(a, b, Volumes::boxes_and_spheres)});
  all.push_back({"distance_rss", distances_of_fcl(a, b, Volumes::spheres)});
  return all;
}

/// How far one distance lies outside the other's bounds, in cells.
double difference(const Length& ours, const Length& theirs) {
  return std::max({0.0, ours.lower - theirs.upper, theirs.lower - ours.upper});
}

/// Poses of a class without those beyond flashbvh's range of distances.
std::vector<Placed> poses_in_range(const Meshes& meshes, PoseSearch& search, Proximity proximity,
                                   bool rotated) {
  std::vector<Placed> poses;
  while (poses.size() < kPoses) {
    const Placed placed = placed_of(search.next(proximity, rotated));
    if (distance(*meshes.a, *meshes.b, placed.pose).in_range) {
      poses.push_back(placed);
    }
  }
  return poses;
}

void print_differences(const std::string& of, DistanceMeter& flashbvh, const Named& named) {
  double most = 0;
  double most_of_length = 0;
  int count = 0;
  for (std::size_t pose = 0; pose < kPoses; ++pose) {
    const Length ours = flashbvh.length(pose);
    const double cells = difference(ours, named.library->length(pose));
    const double of_length = cells / std::max(ours.lower, 1.0);
    most = std::max(most, cells);
    most_of_length = std::max(most_of_length, of_length);
    count += of_length > kTolerance ? 1 : 0;
  }
  std::printf("length %s %s %zu %d %.3g %.3g\n", of.c_str(), named.name, kPoses, count, most,
              most_of_length);
}

}  // namespace

void compare_distances(const PairOfMeshes& meshes, bool rotated) {
  PoseSearch search(meshes.searched, meshes.queried, kSeed);
  flashbvh::test::Random random(kSeed);
  const std::vector<Named> libraries = all_libraries(*meshes.queried.a, *meshes.queried.b);
  for (const Proximity proximity : kApart) {
    const std::string of = meshes.name + " " + name_of_motion(rotated) + " " +
                           kProximityNames[static_cast<std::uint32_t>(proximity)];
    const auto poses = poses_in_range(meshes.queried, search, proximity, rotated);
    std::vector<Timed> timed;
    for (const Named& named : libraries) {
      named.library->set_poses(poses);
      print_differences(of, *libraries[0].library, named);
      timed.push_back({named.name, named.library.get()});
    }
    print_times(timed, Wanted::distance, of, random);
  }
}

}  // namespace compare
