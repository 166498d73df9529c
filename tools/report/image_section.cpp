#include "flashbvh/detail/image_parts.hpp"
#include "report/sections.hpp"

#include <vector>

#include "report/html.hpp"
#include "report/sections.hpp"
#include "report/tree_shape.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Where an image's bytes go.
struct Part {
  const char* name;
  const char* use;
  std::uint64_t bytes;  ///< with the gap after it
};

std::vector<Part> parts_of(const ImageHeader& header) {
  const detail::ImageOffsets at = detail::image_offsets(header);
  const bool pre = header.layout == static_cast<std::uint8_t>(Layout::pre_indexed);
  const std::vector<Part> all = {
      {"nodes", "boxes, links and ranks", at.levels - at.nodes},
      {"triangles", "three vertex numbers each", at.triangle_ids - at.triangles},
      {"vertices", "three coordinates each", at.end - at.vertices},
      {"triangle ids", "their numbers in the mesh file", at.leaf_offsets - at.triangle_ids},
      {"leaf offsets", "the first triangle of each leaf", at.vertices - at.leaf_offsets},
      {"levels", "for the paper&#39;s alternating rule alone", at.climb - at.levels},
      {pre ? "parents" : "right child levels", "likewise", at.triangles - at.climb},
      {"header", "counts, cell and checksum", at.nodes},
  };
  std::vector<Part> present;
  for (const Part& part : all) {
    if (part.bytes != 0) {
      present.push_back(part);
    }
  }
  return present;
}

std::string bar(const std::vector<Part>& parts, std::uint64_t total) {
  std::string label;
  std::string pieces;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    label +=
        (i == 0 ? "" : ", ") + std::string(parts[i].name) + " " + percent(parts[i].bytes, total);
    pieces += concat("<span class=p", i, " style=\"flex-grow:", parts[i].bytes, "\"></span>");
  }
  return "<div class=bar role=img aria-label=\"" + label + "\">" + pieces + "</div>\n";
}

/// A bar and a table.
std::string bytes_by_part(const ImageFile& image) {
  const ImageHeader& header = image.header();
  const std::vector<Part> parts = parts_of(header);
  const double triangles = header.triangle_count;
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const std::string& use, std::uint64_t bytes) {
    rows.push_back({name + (use.empty() ? "" : "<small>" + use + "</small>"), grouped(bytes),
                    percent(bytes, header.byte_count),
                    fixed(static_cast<double>(bytes) / triangles, 1)});
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    add(concat("<i class=\"key p", i, "\"></i>", parts[i].name), parts[i].use, parts[i].bytes);
  }
  add("the image", "", header.byte_count);
  return "<h3>Bytes</h3>\n" + bar(parts, header.byte_count) +
         table("<span class=hide>Bytes by part</span>",
               {{"part", false}, {"bytes", true}, {"share", true}, {"per triangle", true}}, rows);
}

double bytes_per_triangle(const ImageHeader& header) {
  return static_cast<double>(header.byte_count) / header.triangle_count;
}

/// Lengths come from the file with all their digits.
std::string length_of(double length) {
  return significant(length, 4);
}

std::string fact(const char* name, const std::string& value, const std::string& note = "") {
  return std::string("<div><dt>") + name + "</dt><dd>" + value +
         (note.empty() ? "" : "<small>" + note + "</small>") + "</dd></div>\n";
}

std::string key_figures(const Subject& subject) {
  const ImageHeader& header = subject.image.header();
  return "<dl class=facts>\n" + fact("triangles", grouped(header.triangle_count)) +
         fact("vertices", grouped(header.vertex_count)) +
         fact("nodes", grouped(header.node_count), counted(header.leaf_count, "leaf", "leaves")) +
         fact("depth", grouped(header.depth), "of the deepest leaf") +
         fact("bytes", grouped(header.byte_count),
              fixed(bytes_per_triangle(header), 1) + " per triangle") +
         fact("layout", layout_name(subject.image.layout()),
              concat(header.index_bits, "-bit indices")) +
         "</dl>\n";
}

std::string size_of(const Subject& subject) {
  const double cell = subject.image.cell();
  const detail::Box& box = subject.box;
  const auto side = [&](int low, int high) { return length_of((high - low) * cell); };
  return side(box.lower.x, box.upper.x) + " &times; " + side(box.lower.y, box.upper.y) +
         " &times; " + side(box.lower.z, box.upper.z);
}

std::string rounding(const Subject& subject) {
  const double cell = subject.image.cell();
  const double deviation = subject.image.deviation();
  return "<h3>Rounding</h3>\n<dl class=facts>\n" +
         fact("cell", length_of(cell), "in the mesh&#39;s unit") +
         fact("largest deviation", length_of(deviation),
              fixed(deviation / cell, 2) + " cells; how far rounding moved a vertex") +
         "</dl>\n<dl class=facts>\n" + fact("size along x, y and z", size_of(subject)) + "</dl>\n";
}

std::string warning_list(const Subject& subject) {
  std::string html = "<h3>Warnings</h3>\n";
  if (subject.warnings.empty()) {
    return html +
           "<p class=good>None: the surface is closed, and every triangle has an area of its "
           "own.</p>\n";
  }
  html += "<ul class=warnings>\n";
  for (const std::string& warning : subject.warnings) {
    html += "<li>" + warning + "</li>\n";
  }
  return html + "</ul>\n<p class=note>On the lattice. Queries answer exactly all the same.</p>\n";
}

}  // namespace

std::string image_section(const Subject& subject) {
  return concat("<section id=m", subject.number, ">\n<h2>", escaped(subject.name), "</h2>\n",
                key_figures(subject), pictures(subject), "<div class=columns>\n<div>\n",
                bytes_by_part(subject.image), rounding(subject), warning_list(subject),
                "</div>\n<div>\n", histograms(subject.shape), "</div>\n</div>\n</section>\n");
}

std::string summary(const std::vector<const Subject*>& subjects) {
  std::vector<std::vector<std::string>> rows;
  for (const Subject* const subject : subjects) {
    const ImageHeader& header = subject->image.header();
    rows.push_back({concat("<a href=\"#m", subject->number, "\">", escaped(subject->name), "</a>"),
                    grouped(header.triangle_count), grouped(header.node_count),
                    grouped(header.depth), grouped(header.byte_count),
                    fixed(bytes_per_triangle(header), 1), length_of(subject->image.cell()),
                    length_of(subject->image.deviation()),
                    std::to_string(subject->warnings.size())});
  }
  return table("Images",
               {{"mesh", false},
                {"triangles", true},
                {"nodes", true},
                {"depth", true},
                {"bytes", true},
                {"per triangle", true},
                {"cell", true},
                {"deviation", true},
                {"warnings", true}},
               rows);
}

}  // namespace flashbvh::tool
