// Compares pairs of triangles that intersect.
#include <algorithm>
#include <cstdio>

#include "comparison.hpp"

using namespace figures;

namespace compare {
namespace {

struct Named {
  const char* name;
  std::unique_ptr<Collider> library;
  Heap made{};  ///< allocated by its construction
};

std::vector<Named> all_libraries(const flashbvh::Mesh& a, const flashbvh::Mesh& b) {
  std::vector<Named> all;
  const auto add = [&all](const char* name, const auto& make) {
    count_heap();
    Named named = {name, make()};
    named.made = counted_heap();
    all.push_back(std::move(named));
  };
  add("flashbvh", [&] { return with_flashbvh(a, b, PoseMade::before); });
  add("opcode", [&] { return with_opcode(a, b, Matrices::both); });
  add("fcl", [&] { return with_fcl(a, b); });
  add("bullet", [&] { return with_bullet(a, b); });
  add("embree", [&] { return with_embree(a, b); });
  add("flashbvh_pose", [&] { return with_flashbvh(a, b, PoseMade::in_the_query); });
  add("opcode_one", [&] { return with_opcode(a, b, Matrices::of_b); });
  return all;
}

struct Found {
  std::size_t by_flashbvh = 0;
  std::size_t by_other = 0;
  std::size_t by_one = 0;  ///< found by only one of the two
};

void add_pairs(std::vector<Pair> ours, std::vector<Pair> theirs, Found& found) {
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  std::vector<Pair> differing;
  std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                std::back_inserter(differing));
  found.by_flashbvh += ours.size();
  found.by_other += theirs.size();
  found.by_one += differing.size();
}

class Collisions {
 public:
  Collisions(const PairOfMeshes& meshes, bool rotated)
      : of_(meshes.name + " " + name_of_motion(rotated) + " "),
        rotated_(rotated),
        search_(meshes.searched, meshes.queried, kSeed),
        libraries_(all_libraries(*meshes.queried.a, *meshes.queried.b)),
        found_(libraries_.size()) {}

  void run() {
    for (std::uint32_t i = 0; i < kProximities; ++i) {
      const auto proximity = static_cast<Proximity>(i);
      set_poses(proximity);
      time(Wanted::all, kProximityNames[i]);
      if (proximity == Proximity::intersecting) {
        print_heap();
        time(Wanted::first, "first");
      }
    }
    for (std::size_t i = 0; i < libraries_.size(); ++i) {
      std::printf("pairs %s%s %zu %zu %zu\n", of_.c_str(), libraries_[i].name,
                  found_[i].by_flashbvh, found_[i].by_other, found_[i].by_one);
    }
  }

 private:
  void set_poses(Proximity proximity) {
    std::vector<Placed> poses;
    while (poses.size() < kPoses) {
      poses.push_back(placed_of(search_.next(proximity, rotated_)));
    }
    for (std::size_t i = 0; i < libraries_.size(); ++i) {
      libraries_[i].library->set_poses(poses);
      for (std::size_t pose = 0; pose < kPoses; ++pose) {
        add_pairs(libraries_[0].library->pairs(pose), libraries_[i].library->pairs(pose),
                  found_[i]);
      }
    }
  }

  /// Prints the allocations to make each library, and a query's mean allocations.
  void print_heap() {
    for (const Named& named : libraries_) {
      count_heap();
      (void)named.library->query_all(Wanted::all);
      std::printf("heap %s%s %zu %zu %.2f\n", of_.c_str(), named.name, named.made.allocations,
                  named.made.bytes,
                  static_cast<double>(counted_heap().allocations) / static_cast<double>(kPoses));
    }
  }

  void time(Wanted wanted, const char* of_class) {
    std::vector<Timed> timed;
    for (const Named& named : libraries_) {
      timed.push_back({named.name, named.library.get()});
    }
    print_times(timed, wanted, of_ + of_class, random_);
    // Without other libraries in between, which would evict the caches.
    print_times({{"flashbvh_alone", timed[0].library}, {"opcode_alone", timed[1].library}}, wanted,
                of_ + of_class, random_);
  }

  std::string of_;
  bool rotated_;
  PoseSearch search_;
  flashbvh::test::Random random_{kSeed};
  std::vector<Named> libraries_;
  std::vector<Found> found_;  ///< one per library
};

}  // namespace

void compare_collisions(const PairOfMeshes& meshes, bool rotated) {
  Collisions(meshes, rotated).run();
}

}  // namespace compare
