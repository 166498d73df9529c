#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "flashbvh/image.hpp"
#include "report/html.hpp"
#include "report/page.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A part of the bytes that firmware links.
struct Part {
  const char* name;
  std::uint64_t bytes;  ///< including the gap after it
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

/// A bar whose width is the total's share of the largest total.
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
    const auto cells = static_cast<double>(subject.box.upper[axis] - subject.box.lower[axis]);
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
           "of the image and the file from each other: " +
               fixed(image.deviation() / image.cell(), 2) + " cells"));
}

std::string warning_list(const Subject& subject) {
  std::string html;
  for (const Warning& warning : subject.warnings) {
    html += "<li>" + key(warning.marks.colour, warning.text) + "</li>\n";
  }
  if (html.empty()) {
    html =
        "<p class=good>Nothing odd: the surface is closed, and every triangle has an area of its "
        "own.</p>\n";
  } else {
    html = "<ul class=warnings>\n" + html + "</ul>\n" +
           note(
               "On the lattice; where the mesh is shown alone, it has them in these colours. "
               "Queries answer exactly all the same.");
  }
  if (subject.left_out != 0) {
    html += note(counted(subject.left_out, "triangle was", "triangles were") +
                 " left out when the mesh was baked; the others kept their numbers.");
  }
  return html;
}

}  // namespace

std::string image_section(const Subject& subject) {
  return section(concat("m", subject.number), escaped(subject.name),
                 key_figures(subject) + warning_list(subject));
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
         grouped(header.triangle_count), grouped(subject->flash),
         bar(parts_of(*subject), subject->flash, most)});
  }
  std::string keys = "<p class=keys>";
  const std::array<Part, 5> parts = parts_of(*subjects[0]);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    keys += key(concat("p", i), parts[i].name);
  }
  return section("flash", "Flash by mesh",
                 "<div class=hist>\n" + table("", {"mesh", "#triangles", "#bytes", "bar"}, rows) +
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
