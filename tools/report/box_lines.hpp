// The boxes of a tree's levels as lines over a picture of the mesh.
#ifndef FLASHBVH_TOOLS_REPORT_BOX_LINES_HPP
#define FLASHBVH_TOOLS_REPORT_BOX_LINES_HPP

#include <string>
#include <vector>

#include "report/tree_shape.hpp"
#include "report/view.hpp"

namespace flashbvh::report {

/// A level whose boxes are drawn.
struct Level {
  std::uint32_t depth;
  std::vector<NodeBox> boxes;
};

/// The upper levels, as far as their boxes can still be told apart and the page stays small.
std::vector<Level> drawn_levels(const tool::AnyTree& any, const TreeShape& shape);

/// Levels drawn at most.
constexpr std::size_t kMostLevels = 12;

/// Units of the drawing's side.
constexpr std::int64_t kDrawingSide = 4800;

/// A group of SVG paths; the style says which level is to be seen. `root`: the mesh's box.
std::string box_lines(const Level& level, const View& view, const Box& root);

}  // namespace flashbvh::report

#endif
