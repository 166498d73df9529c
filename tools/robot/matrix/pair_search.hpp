// Decides whether two links can collide: branch and bound over boxes of joint values.
//
// At the middle of a joint box, a query decides whether the links are within eps: the motion within
// the box, and the slack. If not, they collide nowhere in it. If they intersect, they can collide;
// otherwise the box is cut in two where it moves them most. Boxes wait on a stack, so memory grows
// with the depth alone.
//
// A link that turns about its own axis over a large range makes many boxes and hardly moves. A
// second proof uses the solid that it sweeps in a full turn about the joint next to it. If nothing
// meets the solid, the joint's angle does not matter, and the search has a dimension less.
//
// A search for witnesses descends in the links' distance. It starts from the nearest of many points
// spread over the ranges.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/pair_space.hpp"

namespace flashbvh::tool {

enum class SearchEnd : std::uint8_t {
  apart,       ///< apart at all values
  near,        ///< at `point` they intersect, or are within `distance`
  unresolved,  ///< within `distance`, slack and resolution at `point`
  cut_off,     ///< out of joint boxes or of time
};

struct SearchResult {
  SearchEnd end = SearchEnd::apart;
  std::vector<double> point;
  std::uint64_t joint_boxes = 0;  ///< searched
};

/// Decides whether the links can intersect or, given a `distance` in cells, come so near with
/// slack.
SearchResult search_pair(const PairSpace& space, const MatrixOptions& options, double distance = 0);

/// True if solids of revolution of the links, or of one of them, prove that they never come within
/// `distance` cells or meet. False proves nothing. Adds the searched joint boxes to `joint_boxes`.
/// `cell`: with which their meshes are baked.
bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, std::uint64_t& joint_boxes, double distance = 0);

/// Point `number` of a sequence that fills the ranges evenly, without their ends: Halton, "On the
/// efficiency of certain quasi-random sequences of points in evaluating multi-dimensional
/// integrals", Numerische Mathematik 2, 1960.
std::vector<double> spread_point(const PairSpace& space, std::uint32_t number);

/// True if the links intersect at each of the first `places` points of spread_point(). Proves
/// nothing for other points.
bool intersect_wherever_tried(const PairSpace& space, std::uint32_t places);

/// Tests `starts` points and descends from the nearest few, while time lasts. None proves nothing.
std::optional<std::vector<double>> find_intersection(const PairSpace& space,
                                                     const MatrixOptions& options,
                                                     std::uint32_t starts);

/// Moves a point at which the links intersect deeper: each variable in turn to the middle of its
/// intersecting range, measured by doubling steps. The links then intersect with other rounding of
/// poses, too.
std::vector<double> deepened(const PairSpace& space, std::vector<double> point);

}  // namespace flashbvh::tool
