#include "report/sections.hpp"

#include <array>
#include <string>
#include <vector>

#include "report/html.hpp"
#include "report/png.hpp"
#include "report/raster.hpp"
#include "report/tree_shape.hpp"
#include "report/view.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A level whose boxes are drawn.
struct Level {
  std::uint32_t depth;
  std::vector<NodeBox> boxes;
};

/// Boxes of a level that is drawn, at most: more can't be told apart.
constexpr std::size_t kMostBoxes = 320;
/// Levels drawn at most.
constexpr std::size_t kMostLevels = 24;

/// Units of the drawing's side.
constexpr std::int64_t kDrawingSide = 4800;

/// So many boxes are filled, too: more would hide the mesh.
constexpr std::size_t kMostFilled = 40;
constexpr std::size_t kColours = 4;

/// "12-3": a minus sign separates, too.
std::string numbers(std::int64_t x, std::int64_t y) {
  return concat(x, (y < 0 ? "" : " "), y);
}

std::string line(const Projected& way, bool back = false) {
  return back ? "l" + numbers(-way.x, -way.y) : "l" + numbers(way.x, way.y);
}

/// Seen along an axis: the rectangle.
std::string rectangle(const Projected& start, const Projected& u, const Projected& v) {
  return concat("M", numbers(start.x, start.y), "h", u.x, "v", v.y, "h", -u.x, "z");
}

/// The outline and the three edges that end in the corner in front: low x and y and high z come
/// first, where the corner in front is high x, low y, high z.
std::string solid(const Projected& start, const Projected& x, const Projected& y,
                  const Projected& z) {
  // The inner edges run the way of the outline, so that what they enclose stays filled.
  return "M" + numbers(start.x, start.y) + line(y) + line(x) + line(z, true) + line(y, true) +
         line(x, true) + "zm" + numbers(x.x + y.x, x.y + y.y) + line(y, true) + line(x, true) +
         "m" + numbers(x.x, x.y) + line(z, true);
}

std::string path_of(const detail::Box& box, const Projection& projection) {
  const Projected x = projection.rotate({box.upper.x - box.lower.x, 0, 0});
  const Projected y = projection.rotate({0, box.upper.y - box.lower.y, 0});
  const Projected z = projection.rotate({0, 0, box.upper.z - box.lower.z});
  return solid(projection.project({box.lower.x, box.lower.y, box.upper.z}), x, y, z);
}

std::string flat_path_of(const detail::Box& box, const Projection& projection) {
  const Projected low = projection.project(box.lower);
  const Projected high = projection.project(box.upper);
  return rectangle(low, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0});
}

/// Whether the picture's sides are axes, so that boxes are rectangles.
bool is_along_axis(const View& view) {
  return view.right[0] == View::kUnit || view.right[1] == View::kUnit;
}

/// Those that can be drawn, from the root on.
std::vector<Level> drawn_levels(const AnyTree& any, const TreeShape& shape) {
  std::vector<Level> levels;
  for (std::uint32_t depth = 0; depth < shape.nodes_by_depth.size(); ++depth) {
    if (shape.nodes_by_depth[depth] <= kMostBoxes && levels.size() < kMostLevels) {
      levels.push_back({depth, boxes_at(any, depth)});
    }
  }
  return levels;
}

/// A group of SVG paths; the style shows it by its `place` in the list of levels. `root`: the
/// mesh's box.
std::string box_lines(const Level& level, std::size_t place, const View& view,
                      const detail::Box& root) {
  constexpr std::int64_t margin = kPictureMargin * kDrawingSide / kPictureSide;
  const Projection projection(view, root, kDrawingSide, margin);
  const bool flat = is_along_axis(view);
  std::array<std::string, kColours> paths;
  for (std::size_t i = 0; i < level.boxes.size(); ++i) {
    const detail::Box& box = level.boxes[i].box;
    paths[i % kColours] += flat ? flat_path_of(box, projection) : path_of(box, projection);
  }
  std::string svg =
      concat("<g class=\"L L", place, (level.boxes.size() <= kMostFilled ? " F" : ""), "\">");
  for (std::size_t i = 0; i < kColours; ++i) {
    if (!paths[i].empty()) {
      svg += concat("<path class=k", i, " d=\"", paths[i], "\"/>");
    }
  }
  return svg + "</g>\n";
}

/// The level that is shown at first: the deepest of few boxes.
constexpr std::size_t kFewBoxes = 20;

std::size_t first_choice(const std::vector<Level>& levels) {
  std::size_t choice = 0;
  while (choice + 1 < levels.size() && levels[choice + 1].boxes.size() <= kFewBoxes) {
    ++choice;
  }
  return choice;
}

std::string radio(const Subject& subject, const std::string& value, const std::string& label,
                  bool checked) {
  const std::string group = concat("v", subject.number);
  const std::string id = group + "-" + value;
  return "<input type=radio name=" + group + " id=" + id + " class=\"R R" + value + "\"" +
         (checked ? " checked" : "") + "><label for=" + id + ">" + label + "</label>\n";
}

/// What the level shown consists of. `place`: in the list of levels, which the style counts by.
std::string level_note(const Level& level, std::size_t place) {
  std::size_t leaves = 0;
  for (const NodeBox& box : level.boxes) {
    leaves += box.is_leaf ? 1 : 0;
  }
  return concat(
      "<span class=\"L L", place, "\">Level ", level.depth, ": ",
      counted(level.boxes.size(), "box", "boxes"),
      (leaves == 0 ? "" : ", " + grouped(leaves) + (leaves == 1 ? " a leaf" : " of them leaves")),
      ". </span>\n");
}

std::string drawing(const Subject& subject, const View& view, const std::vector<Level>& levels) {
  const std::string side = std::to_string(kDrawingSide);
  std::string svg = "<figure><svg viewBox=\"0 0 " + side + " " + side +
                    "\" role=img aria-label=\"" + escaped(subject.name) + ", " + view.name + ": " +
                    view.caption + ", with the boxes of the level chosen\">\n<image width=" + side +
                    " height=" + side + " href=\"" +
                    data_uri(picture_of(subject.triangles, view, subject.box)) + "\"/>\n";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    svg += box_lines(levels[i], i, view, subject.box);
  }
  return svg + "</svg><figcaption><b>" + view.name + "</b> " + view.caption +
         "</figcaption></figure>\n";
}

}  // namespace

std::string pictures(const Subject& subject) {
  const std::vector<Level> levels = drawn_levels(subject.image.tree(), subject.shape);
  const std::size_t first = first_choice(levels);
  std::string html =
      "<fieldset class=look><legend>Boxes of level</legend>\n" + radio(subject, "n", "none", false);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    html += radio(subject, std::to_string(i), std::to_string(levels[i].depth), i == first);
  }
  html += "<p class=note>";
  for (std::size_t i = 0; i < levels.size(); ++i) {
    html += level_note(levels[i], i);
  }
  if (levels.size() != subject.shape.nodes_by_depth.size()) {
    html += concat("Drawn are up to ", kMostLevels, " levels of up to ", kMostBoxes, " boxes.");
  }
  html += "</p>\n<div class=views>\n";
  for (const View& view : views()) {
    html += drawing(subject, view, levels);
  }
  return html + "</div></fieldset>\n";
}

std::string picture_style() {
  std::string style = ".L{display:none}\n";
  for (std::size_t i = 0; i < kMostLevels; ++i) {
    const std::string place = std::to_string(i);
    style.append(i == 0 ? ".R" : ",.R").append(place).append(":checked~* .L").append(place);
  }
  return style + "{display:inline}\n";
}

}  // namespace flashbvh::tool
