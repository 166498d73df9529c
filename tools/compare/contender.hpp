// What is compared: a library with two meshes and a set of poses, which it visits in turn.
//
// A Collider finds pairs of triangles, a Ruler distances, a Caster what a ray hits.
#ifndef FLASHBVH_TOOLS_COMPARE_CONTENDER_HPP
#define FLASHBVH_TOOLS_COMPARE_CONTENDER_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/ray.hpp"
#include "support/rotations.hpp"

namespace compare {

/// Where B lies in A's frame.
struct Placed {
  flashbvh::test::Rotation rotation;
  std::int32_t cells[3];
  flashbvh::Pose pose;  ///< made of these
};

/// All pairs, the first that is found, or the distance.
enum class Wanted { all, first, distance };

/// Two triangles, by their numbers in the source meshes.
using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// A loop over all poses is one virtual call: nothing of it counts as the query's.
class Contender {
 public:
  virtual ~Contender() = default;

  /// Not timed: what the library takes as a pose is made here.
  virtual void set_poses(const std::vector<Placed>& poses) = 0;
  /// Asks about each pose in turn; what is found is counted, whatever it is.
  virtual std::size_t ask_all(Wanted wanted) = 0;
};

class Collider : public Contender {
 public:
  /// All pairs under one of the poses, in any order.
  virtual std::vector<Pair> pairs(std::size_t pose) = 0;
};

/// A distance in cells: between these two.
struct Length {
  double lower;
  double upper;
};

class Ruler : public Contender {
 public:
  /// The distance under one of the poses.
  virtual Length length(std::size_t pose) = 0;
};

// The meshes outlive what is made of them.

enum class PoseMade { before, in_the_query };
std::unique_ptr<Collider> with_flashbvh(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                                        PoseMade pose_made);

/// `both`: matrices for A, the identity, and B; `of_b`: null for A, which saves a product.
enum class Matrices { both, of_b };
/// Trees as ODE builds them.
std::unique_ptr<Collider> with_opcode(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                                      Matrices matrices);

/// Oriented boxes and spheres (OBBRSS), binary64.
std::unique_ptr<Collider> with_fcl(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b);

enum class Seeds { none, last_pose };
/// `last_pose`: each distance begins with the witness of a pose near by.
std::unique_ptr<Ruler> ruler_of_flashbvh(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                                         Seeds seeds);

/// `spheres`: swept over rectangles (RSS), as PQP has them; `boxes_and_spheres`: OBBRSS.
enum class Volumes { boxes_and_spheres, spheres };
std::unique_ptr<Ruler> ruler_of_fcl(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b,
                                    Volumes volumes);

/// GImpact: quantized boxes, binary32, no margin.
std::unique_ptr<Collider> with_bullet(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b);

/// Of one mesh, in cells.
class Caster {
 public:
  virtual ~Caster() = default;
  /// How much of the way to the nearest hit, 0 to 1; more than 1 if nothing is hit.
  virtual double nearest(const flashbvh::Segment& segment) = 0;
};

constexpr double kNoHit = 2;
std::unique_ptr<Caster> caster_of_flashbvh(const flashbvh::PostMesh& mesh);
std::unique_ptr<Caster> caster_of_opcode(const flashbvh::PostMesh& mesh);
std::unique_ptr<Caster> caster_of_bullet(const flashbvh::PostMesh& mesh);

}  // namespace compare

#endif
