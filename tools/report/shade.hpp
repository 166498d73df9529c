// How bright a triangle looks.
#ifndef FLASHBVH_TOOLS_REPORT_SHADE_HPP
#define FLASHBVH_TOOLS_REPORT_SHADE_HPP

#include <array>
#include <cstdint>

#include "report/view.hpp"

namespace flashbvh::report {

/// From 0, dark, to `shades` - 1. Both sides of a triangle look alike: which one is the outside
/// need not be told right by the mesh.
std::uint32_t shade_of(const std::array<Vertex, 3>& triangle, const View& view,
                       std::uint32_t shades);

}  // namespace flashbvh::report

#endif
