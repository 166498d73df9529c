#include "report/image_section.hpp"

#include "report/byte_parts.hpp"
#include "report/histograms.hpp"
#include "report/html.hpp"
#include "report/pictures.hpp"
#include "text/numbers.hpp"

namespace flashbvh::report {
namespace {

double bytes_per_triangle(const ImageHeader& header) {
  return static_cast<double>(header.byte_count) / header.triangle_count;
}

/// Lengths come from the file with all their digits.
std::string length_of(double length) {
  return tool::significant(length, 4);
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
              tool::fixed(bytes_per_triangle(header), 1) + " per triangle") +
         fact("layout", tool::layout_name(subject.image.layout()),
              std::to_string(header.index_bits) + "-bit indices") +
         "</dl>\n";
}

std::string size_of(const Subject& subject) {
  const double cell = subject.image.cell();
  const Box& box = subject.box;
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
              tool::fixed(deviation / cell, 2) + " cells; how far rounding moved a vertex") +
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
  return "<section id=m" + std::to_string(subject.number) + ">\n<h2>" + escaped(subject.name) +
         "</h2>\n" + key_figures(subject) + pictures(subject) + "<div class=columns>\n<div>\n" +
         bytes_by_part(subject.image) + rounding(subject) + warning_list(subject) +
         "</div>\n<div>\n" + histograms(subject.shape) + "</div>\n</div>\n</section>\n";
}

std::string summary(const std::vector<const Subject*>& subjects) {
  std::vector<std::vector<std::string>> rows;
  for (const Subject* const subject : subjects) {
    const ImageHeader& header = subject->image.header();
    rows.push_back(
        {"<a href=\"#m" + std::to_string(subject->number) + "\">" + escaped(subject->name) + "</a>",
         grouped(header.triangle_count), grouped(header.node_count), grouped(header.depth),
         grouped(header.byte_count), tool::fixed(bytes_per_triangle(header), 1),
         length_of(subject->image.cell()), length_of(subject->image.deviation()),
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

}  // namespace flashbvh::report
