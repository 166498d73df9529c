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

/// Boxes of a level that is drawn, at most: more can't be told apart.
constexpr std::size_t kMostBoxes = 320;
/// Levels drawn at most.
constexpr std::size_t kMostLevels = 24;

/// Those that can be drawn, from the root on.
std::vector<Level> drawn_levels(const tool::AnyTree& any, const TreeShape& shape);

/// Units of the drawing's side.
constexpr std::int64_t kDrawingSide = 4800;

/// A group of SVG paths; the style shows it by its `place` in the list of levels. `root`: the
/// mesh's box.
std::string box_lines(const Level& level, std::size_t place, const View& view, const detail::Box& root);

}  // namespace flashbvh::report

#endif
