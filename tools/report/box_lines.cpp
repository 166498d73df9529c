#include "report/box_lines.hpp"

#include <array>

#include "report/raster.hpp"

namespace flashbvh::report {
namespace {

/// So many boxes are filled, too: more would hide the mesh.
constexpr std::size_t kMostFilled = 40;
constexpr std::size_t kColours = 4;

/// "12-3": a minus sign separates, too.
std::string numbers(std::int64_t x, std::int64_t y) {
  return std::to_string(x) + (y < 0 ? "" : " ") + std::to_string(y);
}

std::string line(const Projected& way, bool back = false) {
  return back ? "l" + numbers(-way.x, -way.y) : "l" + numbers(way.x, way.y);
}

/// Seen along an axis: the rectangle.
std::string rectangle(const Projected& start, const Projected& u, const Projected& v) {
  return "M" + numbers(start.x, start.y) + "h" + std::to_string(u.x) + "v" + std::to_string(v.y) +
         "h" + std::to_string(-u.x) + "z";
}

/// The outline and the three edges that meet in the corner in front: low x and y and high z come
/// first, where the corner in front is high x, low y, high z.
std::string solid(const Projected& start, const Projected& x, const Projected& y,
                  const Projected& z) {
  // The inner edges run the way of the outline, so that what they enclose stays filled.
  return "M" + numbers(start.x, start.y) + line(y) + line(x) + line(z, true) + line(y, true) +
         line(x, true) + "zm" + numbers(x.x + y.x, x.y + y.y) + line(y, true) + line(x, true) +
         "m" + numbers(x.x, x.y) + line(z, true);
}

std::string path_of(const detail::Box& box, const Projection& projection) {
  const Projected x = projection.turn({box.upper.x - box.lower.x, 0, 0});
  const Projected y = projection.turn({0, box.upper.y - box.lower.y, 0});
  const Projected z = projection.turn({0, 0, box.upper.z - box.lower.z});
  return solid(projection.place({box.lower.x, box.lower.y, box.upper.z}), x, y, z);
}

std::string flat_path_of(const detail::Box& box, const Projection& projection) {
  const Projected low = projection.place(box.lower);
  const Projected high = projection.place(box.upper);
  return rectangle(low, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0});
}

/// Whether the picture's sides are axes, so that boxes are rectangles.
bool is_along_axis(const View& view) {
  return view.right[0] == View::kUnit || view.right[1] == View::kUnit;
}

}  // namespace

std::vector<Level> drawn_levels(const tool::AnyTree& any, const TreeShape& shape) {
  std::vector<Level> levels;
  for (std::uint32_t depth = 0; depth < shape.nodes_by_depth.size(); ++depth) {
    if (shape.nodes_by_depth[depth] <= kMostBoxes && levels.size() < kMostLevels) {
      levels.push_back({depth, boxes_at(any, depth)});
    }
  }
  return levels;
}

std::string box_lines(const Level& level, std::size_t place, const View& view, const detail::Box& root) {
  constexpr std::int64_t margin = kPictureMargin * kDrawingSide / kPictureSide;
  const Projection projection(view, root, kDrawingSide, margin);
  const bool flat = is_along_axis(view);
  std::array<std::string, kColours> paths;
  for (std::size_t i = 0; i < level.boxes.size(); ++i) {
    const detail::Box& box = level.boxes[i].box;
    paths[i % kColours] += flat ? flat_path_of(box, projection) : path_of(box, projection);
  }
  std::string svg = "<g class=\"L L" + std::to_string(place) +
                    (level.boxes.size() <= kMostFilled ? " F" : "") + "\">";
  for (std::size_t i = 0; i < kColours; ++i) {
    if (!paths[i].empty()) {
      svg += "<path class=k" + std::to_string(i) + " d=\"" + paths[i] + "\"/>";
    }
  }
  return svg + "</g>\n";
}

}  // namespace flashbvh::report
