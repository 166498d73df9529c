#include "report/sections.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "report/figure.hpp"
#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Boxes of a level that are drawn: more can't be told apart.
constexpr std::size_t kMostBoxes = 600;

/// So many boxes are filled, too: more would hide the mesh.
constexpr std::size_t kMostFilled = 40;
constexpr std::size_t kBoxColours = 4;

/// Pixels of a picture's side.
constexpr std::int64_t kPictureSide = 480;

/// "12-3": a minus sign separates, too.
std::string numbers(std::int64_t x, std::int64_t y) {
  return concat(x, (y < 0 ? "" : " "), y);
}

std::string line(const Projected& way, bool back = false) {
  return back ? "l" + numbers(-way.x, -way.y) : "l" + numbers(way.x, way.y);
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

std::string path_of(const Bounds& box, const Projection& projection) {
  const Projected x = projection.rotate({box.upper[0] - box.lower[0], 0, 0});
  const Projected y = projection.rotate({0, box.upper[1] - box.lower[1], 0});
  const Projected z = projection.rotate({0, 0, box.upper[2] - box.lower[2]});
  return solid(projection.project({box.lower[0], box.lower[1], box.upper[2]}), x, y, z);
}

/// A group of SVG paths; the style shows it by its level.
std::string box_lines(const Subject& subject, std::size_t level, const View& view,
                      const Frame& frame) {
  const std::vector<NodeBox>& boxes = subject.levels[level];
  const Projection projection(view, frame, kDrawingSide);
  const std::size_t step = (boxes.size() + kMostBoxes - 1) / kMostBoxes;
  std::array<std::string, kBoxColours> paths;
  for (std::size_t i = 0; i < boxes.size(); i += step) {
    paths[i / step % kBoxColours] += path_of(boxes[i].box, projection);
  }
  std::string svg =
      concat("<g class=\"L L", level, (boxes.size() <= kMostFilled ? " F" : ""), "\">");
  for (std::size_t i = 0; i < kBoxColours; ++i) {
    if (!paths[i].empty()) {
      svg += concat("<path class=k", i, " d=\"", paths[i], "\"/>");
    }
  }
  return svg + "</g>\n";
}

std::string radio(const Subject& subject, const std::string& value, const std::string& label,
                  bool checked) {
  const std::string group = concat("v", subject.number);
  const std::string id = group + "-" + value;
  return "<input type=radio name=" + group + " id=" + id + " class=\"R R" + value + "\"" +
         (checked ? " checked" : "") + "><label for=" + id + ">" + label + "</label>\n";
}

/// What the level shown consists of.
std::string level_note(const std::vector<NodeBox>& boxes, std::size_t level) {
  const auto leaves = static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.end(), [](const NodeBox& box) { return box.is_leaf; }));
  const std::size_t step = (boxes.size() + kMostBoxes - 1) / kMostBoxes;
  return concat(
      "<span class=\"L L", level, "\">Level ", level, ": ", counted(boxes.size(), "box", "boxes"),
      (leaves == 0 ? "" : ", " + grouped(leaves) + (leaves == 1 ? " a leaf" : " of them leaves")),
      (step == 1 ? "" : concat("; one in ", step, " is drawn")), ".</span>\n");
}

Scene scene_of(const Subject& subject) {
  Scene scene;
  for (const Triangle& triangle : subject.triangles) {
    if (triangle.paint == kNoArea) {
      for (std::size_t i = 0; i < 3; ++i) {
        scene.lines.push_back({{triangle.corner[i], triangle.corner[(i + 1) % 3]}, kNoArea});
      }
    } else {
      scene.faces.push_back({triangle.corner, triangle.paint});
    }
  }
  // The first line at a place is seen.
  scene.lines.insert(scene.lines.end(), subject.marked_edges.begin(), subject.marked_edges.end());
  return scene;
}

std::string drawing(const Subject& subject, const Scene& scene, const View& view,
                    const Frame& frame) {
  std::string lines;
  for (std::size_t level = 0; level < subject.levels.size(); ++level) {
    lines += box_lines(subject, level, view, frame);
  }
  return figure(draw(scene, view, frame, kPictureSide), view, frame, measure_of(subject.image),
                escaped(subject.name) + ", " + view.name, lines, concat("<b>", view.name, "</b>"));
}

}  // namespace

std::string pictures(const Subject& subject) {
  std::string html = "<fieldset class=look><legend>Boxes of the tree, by level</legend>\n" +
                     radio(subject, "n", "none", true);
  for (std::size_t level = 0; level < subject.levels.size(); ++level) {
    html += radio(subject, std::to_string(level), std::to_string(level), false);
  }
  html += "<p class=note>&#8203;";
  for (std::size_t level = 0; level < subject.levels.size(); ++level) {
    html += level_note(subject.levels[level], level);
  }
  html += "</p>\n<div class=views>\n";
  const Scene scene = scene_of(subject);
  const Frame frame = frame_of(subject.bounds.corners(), views());
  for (const View& view : views()) {
    html += drawing(subject, scene, view, frame);
  }
  return html + "</div></fieldset>\n";
}

std::string level_style(std::size_t levels) {
  std::string style = ".L{display:none}\n";
  for (std::size_t level = 0; level < levels; ++level) {
    style += concat((level == 0 ? ".R" : ",.R"), level, ":checked~* .L", level);
  }
  return style + "{display:inline}\n";
}

}  // namespace flashbvh::tool
