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

class Distances {
 public:
  Distances(const PairOfMeshes& meshes, bool rotated)
      : of_(meshes.name + " " + name_of_motion(rotated) + " "),
        rotated_(rotated),
        meshes_(meshes.queried),
        search_(meshes.searched, meshes.queried, kSeed),
        libraries_(all_libraries(*meshes.queried.a, *meshes.queried.b)) {}

  void run() {
    for (const Proximity proximity : kApart) {
      const std::string of = of_ + kProximityNames[static_cast<std::uint32_t>(proximity)];
      set_poses(proximity);
      std::vector<Timed> timed;
      for (const Named& named : libraries_) {
        print_differences(of, named);
        timed.push_back({named.name, named.library.get()});
      }
      print_times(timed, Wanted::distance, of, random_);
    }
  }

 private:
  /// False for poses beyond flashbvh's range of distances, which are left out.
  bool is_in_range(const Placed& placed) const {
    return distance(*meshes_.a, *meshes_.b, placed.pose).in_range;
  }

  void set_poses(Proximity proximity) {
    std::vector<Placed> poses;
    while (poses.size() < kPoses) {
      const Placed placed = placed_of(search_.next(proximity, rotated_));
      if (is_in_range(placed)) {
        poses.push_back(placed);
      }
    }
    for (const Named& named : libraries_) {
      named.library->set_poses(poses);
    }
  }

  void print_differences(const std::string& of, const Named& named) const {
    double most = 0;
    double most_of_length = 0;
    int count = 0;
    for (std::size_t pose = 0; pose < kPoses; ++pose) {
      const Length ours = libraries_[0].library->length(pose);
      const double cells = difference(ours, named.library->length(pose));
      const double of_length = cells / std::max(ours.lower, 1.0);
      most = std::max(most, cells);
      most_of_length = std::max(most_of_length, of_length);
      count += of_length > kTolerance ? 1 : 0;
    }
    std::printf("length %s %s %zu %d %.3g %.3g\n", of.c_str(), named.name, kPoses, count, most,
                most_of_length);
  }

  std::string of_;
  bool rotated_;
  Meshes meshes_;
  PoseSearch search_;
  flashbvh::test::Random random_{kSeed};
  std::vector<Named> libraries_;
};

}  // namespace

void compare_distances(const PairOfMeshes& meshes, bool rotated) {
  Distances(meshes, rotated).run();
}

}  // namespace compare
