// Whether two links can collide: branch and bound over cells of the variables' values.
//
// At the middle of a cell a query decides whether the links are within eps: how far anything moves
// in the cell, and the slack. No: they collide nowhere in it. Yes: if they intersect there, they
// can; else the cell is cut in two where it moves them most. Cells wait on a stack, so memory grows
// with the depth alone.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_PAIR_SEARCH_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_PAIR_SEARCH_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "robot/matrix/matrix.hpp"
#include "robot/matrix/pair_space.hpp"

namespace flashbvh::tool {

enum class SearchEnd : std::uint8_t {
  apart,       ///< nowhere
  near,        ///< at `point` they intersect, or are within `distance`
  unresolved,  ///< nearer than that and the slack at `point`, or nearly
  cut_off,     ///< there are more cells than may be looked at
};

struct SearchResult {
  SearchEnd end = SearchEnd::apart;
  std::vector<double> point;
  std::uint64_t cells = 0;
};

/// Whether the links can intersect, or, with a `distance` in cells, come so near, slack included.
/// `progress`: what part is decided, now and then.
SearchResult search_pair(const PairSpace& space, const MatrixOptions& options,
                         const std::function<void(double)>& progress, double distance = 0);

}  // namespace flashbvh::tool

#endif
