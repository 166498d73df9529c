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

/// Adds the pairs at all poses.
void add_pairs(Collider& flashbvh, Collider& other, Found& found) {
  for (std::size_t pose = 0; pose < kPoses; ++pose) {
    std::vector<Pair> ours = flashbvh.pairs(pose);
    std::vector<Pair> theirs = other.pairs(pose);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    std::vector<Pair> differing;
    std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                  std::back_inserter(differing));
    found.by_flashbvh += ours.size();
    found.by_other += theirs.size();
    found.by_one += differing.size();
  }
}

/// Prints the allocations to make each library, and a query's mean allocations.
void print_heap(const std::string& of, const std::vector<Named>& libraries) {
  for (const Named& named : libraries) {
    count_heap();
    (void)named.library->query_all(Wanted::all);
    std::printf("heap %s %s %zu %zu %.2f\n", of.c_str(), named.name, named.made.allocations,
                named.made.bytes,
                static_cast<double>(counted_heap().allocations) / static_cast<double>(kPoses));
  }
}

void time(const std::vector<Named>& libraries, Wanted wanted, const std::string& of,
          flashbvh::test::Random& random) {
  std::vector<Timed> timed;
  for (const Named& named : libraries) {
    timed.push_back({named.name, named.library.get()});
  }
  print_times(timed, wanted, of, random);
  // Without other libraries in between, which would evict the caches.
  print_times({{"flashbvh_alone", timed[0].library}, {"opcode_alone", timed[1].library}}, wanted,
              of, random);
}

}  // namespace

void compare_collisions(const PairOfMeshes& meshes, bool rotated) {
  const std::string of = meshes.name + " " + name_of_motion(rotated);
  PoseSearch search(meshes.searched, meshes.queried, kSeed);
  flashbvh::test::Random random(kSeed);
  const std::vector<Named> libraries = all_libraries(*meshes.queried.a, *meshes.queried.b);
  std::vector<Found> found(libraries.size());
  for (std::uint32_t i = 0; i < kProximities; ++i) {
    const auto proximity = static_cast<Proximity>(i);
    std::vector<Placed> poses;
    while (poses.size() < kPoses) {
      poses.push_back(placed_of(search.next(proximity, rotated)));
    }
    for (std::size_t at = 0; at < libraries.size(); ++at) {
      libraries[at].library->set_poses(poses);
      add_pairs(*libraries[0].library, *libraries[at].library, found[at]);
    }
    time(libraries, Wanted::all, of + " " + kProximityNames[i], random);
    if (proximity == Proximity::intersecting) {
      print_heap(of, libraries);
      time(libraries, Wanted::first, of + " first", random);
    }
  }
  for (std::size_t at = 0; at < libraries.size(); ++at) {
    std::printf("pairs %s %s %zu %zu %zu\n", of.c_str(), libraries[at].name, found[at].by_flashbvh,
                found[at].by_other, found[at].by_one);
  }
}

}  // namespace compare
