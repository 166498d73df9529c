// The page about images that `flashbvh report` writes: its parts, and the costs of queries about
// two images, at given or random poses.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/needed_work.hpp"
#include "evaluate/part.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "report/subject.hpp"

namespace flashbvh::tool {

/// The budget of a period on a core.
struct Budget {
  Core core;
  double hz;  ///< periods per second
  double mhz;
  std::string flash = "none";  ///< a name of flash_wait_states()

  double cycles() const { return mhz * 1e6 / hz; }  ///< per period
  /// In cycles; where no cycles are proven, an estimate of one per instruction.
  RunCosts costs() const {
    return core.cycles ? costs_in_cycles(*core.cycles, flash_wait_states().at(flash)) : core.costs;
  }
};

struct ReportOptions {
  /// Poses of B in A's frame, as in `collide`: a file for two images; a folder with a file A-B for
  /// each queried pair; empty: random poses.
  std::string poses;
  std::size_t samples;  ///< random poses per pair; 0: none
  Budget budget;
};

/// Called before each step with its name and its share of the whole work.
using OnStep = std::function<void(const std::string& what, double share)>;

/// One self-contained HTML file, the same bytes for the same images and poses in any folder.
/// UserError as in source_triangles() and read_lattice_poses(). Needs at least one image.
std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images,
                    const ReportOptions& options, const OnStep& step);

/// Classes of poses by the answer of a query.
enum Closeness : std::uint8_t {
  kSeparated,       ///< the boxes of the roots are disjoint
  kSmallProximity,  ///< no pair of leaves overlaps
  kCloseProximity,  ///< no pair of triangles intersects
  kIntersecting,    ///< a pair of triangles intersects
  kClosenessCount,
};

struct PoseCost {
  Pose pose;
  Closeness closeness;
  std::uint64_t work;            ///< of a query for all pairs
  std::uint64_t work_to_first;   ///< of a query that stops at the first pair
  std::uint64_t triangle_pairs;  ///< number of intersecting pairs
};

struct PairCosts {
  bool are_given = false;          ///< the poses are given, not random
  VisitBound bound;                ///< for any pose
  std::vector<PoseCost> poses;     ///< empty with --samples 0
  NeededWork needed;               ///< at these poses, for all pairs of triangles
  NeededWork needed_to_first;      ///< at these poses, for the first pair
  std::uint64_t out_of_range = 0;  ///< impossible poses: a mesh lies too far from its origin
  bool costly = false;             ///< the queries reached kMostVisits
};

/// The relation of B and A at a pose, or in their source frames.
struct Standing {
  std::uint64_t pairs;  ///< number of intersecting triangle pairs
  /// Without such a pair: one of the meshes is inside the other. Nothing: not tested, since a mesh
  /// is not closed, or pre-indexed.
  std::optional<bool> is_inside;
  bool has_distance;
  double distance;  ///< lower bound, in the meshes' unit
};

/// The visits after which sampling stops.
constexpr std::uint64_t kMostVisits = 50'000'000;

/// The costs of the layout's default algorithm at the poses of a file in the format of `collide`.
/// UserError as in read_lattice_poses(), or on a refused query. Precondition: are_partners(a, b).
PairCosts costs_at(const ImageFile& a, const ImageFile& b, const std::string& path);

/// The costs at `count` random poses, the same for the same images: B has any rotation with equal
/// probability. B's box centre has any direction from A's, and any distance up to the sum of half
/// their diagonals.
PairCosts sampled_costs(const ImageFile& a, const ImageFile& b, std::size_t count);

using Subjects = std::vector<const Subject*>;

/// Two subjects queried against each other; the second one moves.
struct QueriedPair {
  const Subject* a;
  const Subject* b;
  PairCosts costs;
  /// At the given poses, or at one pose, as drawn; empty for a mesh and itself.
  std::vector<Standing> standings = {};
  std::optional<std::size_t> live = {};  ///< its index in the page's LivePairs, if any
};

/// A pose in the format of `collide --poses`.
std::string line_of(const Pose& pose, double cell);
/// HTML attributes with the pose that the page's meshes take; empty if the page does not show them.
std::string shown_at(const QueriedPair& pair, const Pose& pose);

/// "ring and peg", as HTML.
std::string title_of(const QueriedPair& pair);

/// The pair with the most work at its costliest pose; without poses, by its bound.
const QueriedPair& costliest(const std::vector<QueriedPair>& pairs);

/// The interactive section of meshes; sets QueriedPair::live. Empty if the program was built
/// without the library for it.
std::string live_part(const Subjects& subjects, std::vector<QueriedPair>& pairs);

/// Flash, RAM and time, and whether they suffice. `pairs`: may be empty.
std::string fit_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                        const ReportOptions& options);

/// The worst of each pair as a matrix, for at least three meshes; the costliest pose and a first
/// contact; given poses as a table; work by class of poses. Empty without poses.
std::string pairs_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                          const ReportOptions& options);

/// Key figures and warnings.
std::string image_section(const Subject& subject);

/// A table of flash by mesh and part, with one scale for all bars.
std::string flash_table(const Subjects& subjects);

/// The version, and the baking options of each image.
std::string foot(const Subjects& subjects);

}  // namespace flashbvh::tool
