// Points and rays as text, in a mesh's frame and unit.
#ifndef FLASHBVH_TOOLS_EVALUATE_POINTS_HPP
#define FLASHBVH_TOOLS_EVALUATE_POINTS_HPP

#include <string>
#include <vector>

#include "flashbvh/ray.hpp"

namespace flashbvh::tool {

/// One point a line, to the nearest cells, halves away from zero; '#' starts a comment; empty lines
/// don't count. UserError, naming the line, if there is none, one is no three numbers, or it lies
/// beyond 2^29 cells.
std::vector<Point> read_lattice_points(const std::string& path, double cell);

/// One ray a line, in the same form: two points, from one to the other; or an origin, a direction
/// and a reach, as segment_of() takes them as floats.
std::vector<Segment> read_lattice_rays(const std::string& path, double cell);

}  // namespace flashbvh::tool

#endif
