// A page about images, what `flashbvh report` writes: its parts, and what queries about two images
// cost, at given poses or at random ones.
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

/// A period of a core.
struct Budget {
  Core core;
  double hz;  ///< periods a second
  double mhz;
  std::string flash = "none";  ///< of flash_wait_states()

  double cycles() const { return mhz * 1e6 / hz; }  ///< of a period
  /// In cycles; roughly, at one an instruction, where no cycles are proven.
  RunCosts costs() const {
    return core.cycles ? flashbvh::detail::with_waits(*core.cycles, flash_wait_states().at(flash))
                       : core.costs;
  }
};

struct ReportOptions {
  /// Of B in A's frame, as `collide` takes them. A file for two images; a folder with a file A-B
  /// for each queried pair; empty: random poses.
  std::string poses;
  std::size_t samples;  ///< random poses of each pair; 0: none
  Budget budget;
};

/// Called before each piece of work with its name and its share of the whole.
using OnStep = std::function<void(const std::string& what, double share)>;

/// One self-contained HTML file, the same bytes for the same images and poses whatever their
/// folder. UserError as source_triangles() and read_lattice_poses(). At least one image.
std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images,
                    const ReportOptions& options, const OnStep& step);

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
  bool are_given = false;          ///< the poses, not drawn at random
  VisitBound bound;                ///< of any pose
  std::vector<PoseCost> poses;     ///< none with --samples 0
  NeededWork needed;               ///< at these, for every pair of triangles
  NeededWork needed_to_first;      ///< for the first pair
  std::uint64_t out_of_range = 0;  ///< poses that can't be: a mesh lies too far from its origin
  bool costly = false;             ///< kMostVisits were reached
};

/// How B is to A at a pose, or as drawn.
struct Standing {
  std::uint64_t pairs;  ///< of triangles that intersect
  bool is_inside;       ///< without such a pair: one of two closed meshes lies in the other
  bool has_distance;
  double distance;  ///< at least; in the meshes' unit
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

using Subjects = std::vector<const Subject*>;

/// Two subjects that are queried against each other, the second moving.
struct QueriedPair {
  const Subject* a;
  const Subject* b;
  PairCosts costs;
  /// At poses that were given, or one, as drawn; none of a mesh and itself.
  std::vector<Standing> standings = {};
  std::optional<std::size_t> live = {};  ///< its place in LivePairs, if the page has it there
};

/// As `collide --poses` reads it.
std::string line_of(const Pose& pose, double cell);
/// Attributes of HTML: the pose that the meshes in the page then have. Nothing if they are not
/// there.
std::string shown_at(const QueriedPair& pair, const Pose& pose);

/// "ring and peg", as HTML.
std::string title_of(const QueriedPair& pair);

/// The pair whose costliest pose, or bound where there are no poses, takes most work.
const QueriedPair& costliest(const std::vector<QueriedPair>& pairs);

/// The section in which meshes answer; sets QueriedPair::live. Nothing if the program was built
/// without the library for it.
std::string live_part(const Subjects& subjects, std::vector<QueriedPair>& pairs);

/// Flash, RAM and time, and whether they are enough. `pairs`: may be none.
std::string fit_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                        const ReportOptions& options);

/// The worst of each pair as a matrix, for three meshes or more; the costliest pose and a first
/// contact; given poses as a table; work by how close the meshes come. Nothing without poses.
std::string pairs_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                          const ReportOptions& options);

/// Key figures and warnings.
std::string image_section(const Subject& subject);

/// Flash by mesh and part, on one scale.
std::string flash_table(const Subjects& subjects);

/// The version, and how each image was baked.
std::string foot(const Subjects& subjects);

}  // namespace flashbvh::tool
