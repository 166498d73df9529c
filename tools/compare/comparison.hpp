// The comparisons: their poses, and how times are taken.
#ifndef FLASHBVH_TOOLS_COMPARE_COMPARISON_HPP
#define FLASHBVH_TOOLS_COMPARE_COMPARISON_HPP

#include <string>

#include "competitor.hpp"
#include "pose_search.hpp"

namespace compare {

constexpr std::uint64_t kSeed = 20240607;
/// Poses of a class, visited in turn, so that no branch predictor knows them by heart.
constexpr std::size_t kPoses = 64;

/// Two meshes, and the trees of theirs that poses are found with.
struct PairOfMeshes {
  std::string name;
  figures::Meshes searched;
  figures::Meshes asked;
};

/// Prints the lines of one pair of meshes.
void compare_collisions(const PairOfMeshes& meshes, bool rotated);
void compare_distances(const PairOfMeshes& meshes, bool rotated);
void compare_approximations(const PairOfMeshes& meshes);
void query_known_answers(const std::string& names, const flashbvh::Mesh& a,
                         const flashbvh::Mesh& b);

inline const char* name_of_motion(bool rotated) {
  return rotated ? "rotated" : "translated";
}

inline Placed placed_of(const figures::Asked& asked) {
  const std::int16_t(&q)[4] = asked.quaternion;
  return {flashbvh::test::rotation_of({q[0], q[1], q[2], q[3]}),
          {asked.cells[0], asked.cells[1], asked.cells[2]},
          figures::pose_of(asked)};
}

struct Timed {
  const char* name;
  Competitor* library;
};

/// Prints what each takes for a query, in nanoseconds; `of`: what stands in front of its name.
void print_times(const std::vector<Timed>& libraries, Wanted wanted, const std::string& of,
                 flashbvh::test::Random& random);

}  // namespace compare

#endif
