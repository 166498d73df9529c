#include "report/sections.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "report/html.hpp"
#include "report/picture.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Most boxes of a level that are drawn: more would be indistinguishable.
constexpr std::size_t kMostBoxes = 500;

/// So many boxes are filled, too: more would hide the mesh.
constexpr std::size_t kMostFilled = 40;
constexpr std::size_t kBoxColours = 4;

/// SVG commands and the corners that they go to, of corners_of(): the outline and the three edges
/// that end in the corner in front. All run the same way round, so that what they enclose is
/// filled.
constexpr std::string_view kBoxPath = "M0l2l3l7l5l4l0m3l1l0m1l5";

/// Of eight corners; bits of the index are set where x and y are high and z is low.
std::vector<LatticePoint> corners_of(const NodeBox& box) {
  std::vector<LatticePoint> points;
  for (unsigned i = 0; i < 8; ++i) {
    points.push_back({(i & 1 ? box.upper : box.lower)[0], (i & 2 ? box.upper : box.lower)[1],
                      (i & 4 ? box.lower : box.upper)[2]});
  }
  return points;
}

std::string path_of(const NodeBox& box, const Frame& frame) {
  const std::vector<LatticePoint> corners = corners_of(box);
  std::string path;
  Vector at{};
  for (std::size_t i = 0; i < kBoxPath.size(); i += 2) {
    const Vector next = frame.project(corners[static_cast<std::size_t>(kBoxPath[i + 1] - '0')]);
    path += kBoxPath[i] + step(at, next);
    at = next;
  }
  return path;
}

/// A group of SVG paths; the style shows it by its level.
std::string box_lines(const Subject& subject, std::size_t level, const Frame& frame) {
  const std::vector<NodeBox>& boxes = subject.levels[level];
  const std::size_t step = (boxes.size() + kMostBoxes - 1) / kMostBoxes;
  std::array<std::string, kBoxColours> paths;
  for (std::size_t i = 0; i < boxes.size(); i += step) {
    paths[i / step % kBoxColours] += path_of(boxes[i], frame);
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

std::string view_of(const Subject& subject, const Frame& frame) {
  Faces faces(subject.triangles.begin(), subject.triangles.end());
  faces.insert(faces.end(), subject.marked_edges.begin(), subject.marked_edges.end());
  std::string lines;
  for (std::size_t level = 0; level < subject.levels.size(); ++level) {
    lines += box_lines(subject, level, frame);
  }
  const char* const name = frame.view.name;
  return figure(faces, frame, measure_of(subject.image), escaped(subject.name) + ", " + name, lines,
                concat("<b>", name, "</b>"));
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
  const NodeBox& root = subject.levels[0][0];
  std::vector<Frame> frames;
  std::int64_t across = 0;
  for (const View& view : views()) {
    frames.emplace_back(view, corners_of(root));
    across = std::max(across, frames.back().across);
  }
  for (Frame& frame : frames) {
    frame.across = across;
    html += view_of(subject, frame);
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
