// Values at which two links intersect, if they are easily found: from where the links are nearest
// of many places spread over the ranges, downhill in their distance.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_WITNESS_SEARCH_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_WITNESS_SEARCH_HPP

#include <optional>
#include <vector>

#include "robot/matrix/pair_space.hpp"

namespace flashbvh::tool {

/// Place `number` of a sequence that fills the ranges evenly, ends left out: Halton, "On the
/// efficiency of certain quasi-random sequences of points in evaluating multi-dimensional
/// integrals", Numerische Mathematik 2, 1960.
std::vector<double> spread_point(const PairSpace& space, std::uint32_t number);

/// Looks at `starts` places and goes downhill from the nearest few. None says nothing.
std::optional<std::vector<double>> find_intersection(const PairSpace& space, std::uint32_t starts);

/// From a place where they intersect to one deeper among such: one variable after the other to the
/// middle of where it may be, as far as doubling steps show. So that a witness is still one where
/// poses are rounded otherwise.
std::vector<double> deepened(const PairSpace& space, std::vector<double> point);

}  // namespace flashbvh::tool

#endif
