// Whether two links can collide: branch and bound over cells of the variables' values.
//
// At the middle of a cell a query decides whether the links are within eps: how far anything moves
// in the cell, and the slack. No: they collide nowhere in it. Yes: if they intersect there, they
// can; else the cell is cut in two where it moves them most. Cells wait on a stack, so memory grows
// with the depth alone.
//
// A proof that spares the joints next to the two links: where what a link sweeps in a full turn
// about such a joint meets nothing, the joint's angle does not matter.
//
// A link that turns about its own axis by a large range makes many cells and hardly moves. Its
// solid of revolution is as near to all else whatever the angle, so a dimension is gone.
//
// Values at which two links intersect, if they are easily found: from where the links are nearest
// of many places spread over the ranges, downhill in their distance.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/pair_space.hpp"

namespace flashbvh::tool {

enum class SearchEnd : std::uint8_t {
  apart,       ///< nowhere
  near,        ///< at `point` they intersect, or are within `distance`
  unresolved,  ///< nearer than that and the slack at `point`, or nearly
  cut_off,     ///< there are more cells than may be looked at, or there is time for
};

struct SearchResult {
  SearchEnd end = SearchEnd::apart;
  std::vector<double> point;
  std::uint64_t cells = 0;
};

/// Whether the links can intersect, or, with a `distance` in cells, come so near, slack included.
SearchResult search_pair(const PairSpace& space, const MatrixOptions& options, double distance = 0);

/// Whether the links are proven never to come within `distance` cells, or to meet, by their solids
/// of revolution or that of one of them. False says nothing. `cells` is increased by those looked
/// at. `cell`: with which their meshes are baked.
bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, std::uint64_t& cells, double distance = 0);

/// Place `number` of a sequence that fills the ranges evenly, ends left out: Halton, "On the
/// efficiency of certain quasi-random sequences of points in evaluating multi-dimensional
/// integrals", Numerische Mathematik 2, 1960.
std::vector<double> spread_point(const PairSpace& space, std::uint32_t number);

/// Whether the links intersect at each of the first `places` of spread_point(). Says nothing of
/// other places.
bool intersect_wherever_tried(const PairSpace& space, std::uint32_t places);

/// Looks at `starts` places and goes downhill from the nearest few, as long as there is time. None
/// says nothing.
std::optional<std::vector<double>> find_intersection(const PairSpace& space,
                                                     const MatrixOptions& options,
                                                     std::uint32_t starts);

/// From a place where they intersect to one deeper among such: one variable after the other to the
/// middle of where it may be, as far as doubling steps show. So that a witness is still one where
/// poses are rounded otherwise.
std::vector<double> deepened(const PairSpace& space, std::vector<double> point);

}  // namespace flashbvh::tool
