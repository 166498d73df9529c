#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "flashbvh/image.hpp"
#include "report/html.hpp"
#include "report/picture.hpp"
#include "report/sections.hpp"
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

/// Where the bytes that firmware links go.
struct Part {
  const char* name;
  std::uint64_t bytes;  ///< with the gap after it
};

std::array<Part, 5> parts_of(const Subject& subject) {
  const ImageOffsets at = image_offsets(subject.image.header());
  const std::uint64_t nodes = at.levels - at.nodes;
  const std::uint64_t corners = at.triangle_ids - at.triangles;
  const std::uint64_t vertices = at.shell_vertices - at.vertices;
  const std::uint64_t ids = at.leaf_offsets - at.triangle_ids;
  return {{{"nodes", nodes},
           {"triangles", corners},
           {"vertices", vertices},
           {"triangle ids", ids},
           {"leaf offsets and the rest", subject.flash - nodes - corners - vertices - ids}}};
}

/// As long as its share of the largest.
std::string bar(const std::array<Part, 5>& parts, std::uint64_t total, std::uint64_t most) {
  std::string label;
  std::string pieces;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    label += (i == 0 ? "" : ", ") + std::string(parts[i].name) + " " + grouped(parts[i].bytes);
    pieces += concat("<span class=p", i, " style=\"flex-grow:", parts[i].bytes, "\"></span>");
  }
  const double width = 100 * static_cast<double>(total) / static_cast<double>(most);
  return "<div class=bar role=img style=\"width:" + fixed(width, 1) + "%\" aria-label=\"" + label +
         "\">" + pieces + "</div>";
}

std::string size_of(const Subject& subject) {
  std::string size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const NodeBox& root = subject.levels[0][0];
    const auto cells = static_cast<double>(root.upper[axis] - root.lower[axis]);
    size += (axis == 0 ? "" : " &times; ") +
            length_of(measure_of(subject.image), cells * subject.image.cell());
  }
  return size;
}

std::string key_figures(const Subject& subject) {
  const ImageFile& image = subject.image;
  const ImageHeader& header = image.header();
  const Measure measure = measure_of(image);
  return facts(
      fact("flash", grouped(subject.flash) + " bytes",
           fixed(static_cast<double>(subject.flash) / header.triangle_count, 1) + " per triangle") +
      fact("triangles", grouped(header.triangle_count),
           counted(header.vertex_count, "vertex", "vertices")) +
      fact("size along x, y and z", size_of(subject),
           measure.suffix.empty() ? "in the mesh&#39;s unit, as all lengths" : "") +
      fact("largest deviation", length_of(measure, image.deviation()),
           "how far rounding moved a vertex: " + fixed(image.deviation() / image.cell(), 2) +
               " cells"));
}

std::string warning_list(const Subject& subject) {
  std::string html;
  for (const Warning& warning : subject.warnings) {
    html += "<li>" + key(class_of(warning.paint), warning.text) + "</li>\n";
  }
  if (html.empty()) {
    html =
        "<p class=good>Nothing odd: the surface is closed, and every triangle has an area of its "
        "own.</p>\n";
  } else {
    html = "<ul class=warnings>\n" + html + "</ul>\n" +
           note("On the lattice, marked in the pictures. Queries answer exactly all the same.");
  }
  if (subject.left_out != 0) {
    html += note(counted(subject.left_out, "triangle was", "triangles were") +
                 " left out when the mesh was baked; the others kept their numbers.");
  }
  return html;
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

std::string image_section(const Subject& subject) {
  return section(concat("m", subject.number), escaped(subject.name),
                 key_figures(subject) + warning_list(subject) + pictures(subject));
}

std::string flash_table(const Subjects& subjects) {
  std::uint64_t most = 0;
  for (const Subject* const subject : subjects) {
    most = std::max(most, subject->flash);
  }
  std::vector<Cells> rows;
  for (const Subject* const subject : subjects) {
    const ImageHeader& header = subject->image.header();
    const auto odd = subject->warnings.size();
    rows.push_back(
        {concat("<a href=\"#m", subject->number, "\">", escaped(subject->name), "</a>",
                (odd == 0 ? "" : "<small>" + counted(odd, "warning", "warnings") + "</small>")),
         grouped(header.triangle_count), grouped(subject->flash), grouped(header.byte_count),
         bar(parts_of(*subject), subject->flash, most)});
  }
  std::string keys = "<p class=keys>";
  const std::array<Part, 5> parts = parts_of(*subjects[0]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    keys += key(concat("p", i), parts[i].name);
  }
  return section(
      "flash", "Flash by mesh",
      "<div class=hist>\n" +
          table("", {"mesh", "#triangles", "#bytes linked", "#as an image", "bar"}, rows) +
          "</div>\n" + keys + "</p>\n");
}

std::string foot(const Subjects& subjects) {
  std::vector<Cells> rows;
  for (const Subject* const subject : subjects) {
    const ImageFile& image = subject->image;
    const ImageHeader& header = image.header();
    rows.push_back({escaped(subject->name), grouped(header.leaf_size), grouped(header.arity),
                    concat(layout_name(image.layout()), ", ", header.index_bits, "-bit indices"),
                    length_of(measure_of(image), image.cell()), grouped(header.node_count),
                    grouped(header.depth)});
  }
  return "<footer>\n" +
         table("How the images were baked",
               {"mesh", "#leaf size, at most", "#arity, at most", "layout", "#cell", "#nodes",
                "#depth"},
               rows) +
         note(concat(version_text(), ", image format ", kImageVersion)) + "</footer>\n";
}

}  // namespace flashbvh::tool
