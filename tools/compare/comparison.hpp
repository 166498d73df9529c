// The comparisons: poses, time measurement, allocations, and the libraries.
//
// A library has two meshes and visits a set of poses in turn: a Collider finds pairs of triangles,
// a DistanceMeter distances, a RayCaster hits of rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/ray.hpp"
#include "pose_search.hpp"
#include "support/rotations.hpp"

namespace compare {

/// B's pose in A's frame.
struct Placed {
  flashbvh::test::Rotation rotation;
  std::int32_t cells[3];
  flashbvh::Pose pose;  ///< made of the two
};

/// The query's result: all pairs, the first found pair, or the distance.
enum class Wanted { all, first, distance };

/// Two triangles, by their numbers in the source meshes.
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// One virtual call runs a loop over all poses, so that a query's time includes no call.
class Competitor {
 public:
  virtual ~Competitor() = default;

  /// Converts each pose to the library's own form. Not timed.
  virtual void set_poses(const std::vector<Placed>& poses) = 0;
  /// Queries each pose in turn; returns a number that depends on all answers.
  virtual std::size_t query_all(Wanted wanted) = 0;
};

class Collider : public Competitor {
 public:
  /// All pairs at one of the poses, in any order.
  virtual std::vector<Pair> pairs(std::size_t pose) = 0;
};

/// A distance in cells, between two bounds.
struct Length {
  double lower;
  double upper;
};

class DistanceMeter : public Competitor {
 public:
  /// The distance at one of the poses.
  virtual Length length(std::size_t pose) = 0;
};

// The meshes must outlive the objects made from them.

enum class PoseMade { before, in_the_query };
std::unique_ptr<Collider> with_flashbvh(const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                                        PoseMade pose_made);

/// `both`: matrices for A (the identity) and B; `of_b`: null for A, which saves a product.
enum class Matrices { both, of_b };
/// Uses trees with ODE's settings.
std::unique_ptr<Collider> with_opcode(const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                                      Matrices matrices);

/// Oriented boxes and spheres (OBBRSS), binary64.
std::unique_ptr<Collider> with_fcl(const flashbvh::Mesh& a, const flashbvh::Mesh& b);

enum class Hint { none, last_pose };
/// `last_pose`: each query starts with the witness of a nearby pose as a hint.
std::unique_ptr<DistanceMeter> distances_of_flashbvh(const flashbvh::Mesh& a,
                                                     const flashbvh::Mesh& b, Hint hint);

/// `spheres`: swept over rectangles (RSS), as in PQP; `boxes_and_spheres`: OBBRSS.
enum class Volumes { boxes_and_spheres, spheres };
std::unique_ptr<DistanceMeter> distances_of_fcl(const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                                                Volumes volumes);

/// GImpact: quantized boxes, binary32, no margin.
std::unique_ptr<Collider> with_bullet(const flashbvh::Mesh& a, const flashbvh::Mesh& b);

/// Boxes by Embree, triangles by Moeller's test, binary32. set_poses() makes a scene of B for each
/// pose, because Embree's scenes have no pose; it does not stop at the first hit.
std::unique_ptr<Collider> with_embree(const flashbvh::Mesh& a, const flashbvh::Mesh& b);

/// Casts rays at one mesh; lengths are in cells.
class RayCaster {
 public:
  virtual ~RayCaster() = default;
  /// The nearest hit's part of the segment, 0 to 1; more than 1 if nothing is hit.
  virtual double nearest(const flashbvh::Segment& segment) = 0;
};

constexpr double kNoHit = 2;
std::unique_ptr<RayCaster> ray_caster_of_flashbvh(const flashbvh::Mesh& mesh);
std::unique_ptr<RayCaster> ray_caster_of_opcode(const flashbvh::Mesh& mesh);
std::unique_ptr<RayCaster> ray_caster_of_bullet(const flashbvh::Mesh& mesh);

struct Heap {
  std::size_t allocations;
  std::size_t bytes;  ///< not freed
};

/// Starts the count. Outside of the two calls, and in timed code, nothing is counted.
void count_heap();
Heap counted_heap();

constexpr std::uint64_t kSeed = 20240607;
/// Poses of a class, visited in turn, so many that branch predictors cannot learn them.
constexpr std::size_t kPoses = 64;

/// Two meshes, and the trees used to search poses.
struct PairOfMeshes {
  std::string name;
  figures::Meshes searched;
  figures::Meshes queried;
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

inline Placed placed_of(const figures::QueryPose& query_pose) {
  const std::int16_t(&q)[4] = query_pose.quaternion;
  return {flashbvh::test::rotation_of({q[0], q[1], q[2], q[3]}),
          {query_pose.cells[0], query_pose.cells[1], query_pose.cells[2]},
          figures::pose_of(query_pose)};
}

/// The poses in a library's own form.
template <class Convert>
auto converted(const std::vector<Placed>& poses, const Convert& convert) {
  std::vector<decltype(convert(poses[0].pose))> made;
  for (const Placed& placed : poses) {
    made.push_back(convert(placed.pose));
  }
  return made;
}

struct Timed {
  const char* name;
  Competitor* library;
};

/// Prints the time of a query for each library, in nanoseconds. `of`: the text before its name.
void print_times(const std::vector<Timed>& libraries, Wanted wanted, const std::string& of,
                 flashbvh::test::Random& random);

}  // namespace compare
