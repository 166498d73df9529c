#include "report/byte_parts.hpp"

#include <vector>

#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::report {
namespace {

struct Part {
  const char* name;
  const char* use;
  std::uint64_t bytes;  ///< with the gap behind it
};

std::vector<Part> parts_of(const ImageHeader& header) {
  const ImageOffsets at = image_offsets(header);
  const bool pre = header.layout == static_cast<std::uint8_t>(Layout::pre_indexed);
  const std::vector<Part> all = {
      {"nodes", "boxes, links and ranks", at.levels - at.nodes},
      {"triangles", "three vertex numbers each", at.sources - at.triangles},
      {"vertices", "three coordinates each", at.end - at.vertices},
      {"sources", "triangle numbers of the mesh file", at.leaf_firsts - at.sources},
      {"leaf table", "the first triangle of each leaf", at.vertices - at.leaf_firsts},
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
    pieces += "<span class=p" + std::to_string(i) +
              " style=\"flex-grow:" + std::to_string(parts[i].bytes) + "\"></span>";
  }
  return "<div class=bar role=img aria-label=\"" + label + "\">" + pieces + "</div>\n";
}

}  // namespace

std::string bytes_by_part(const tool::ImageFile& image) {
  const ImageHeader& header = image.header();
  const std::vector<Part> parts = parts_of(header);
  const double triangles = header.triangle_count;
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const std::string& use, std::uint64_t bytes) {
    rows.push_back({name + (use.empty() ? "" : "<small>" + use + "</small>"), grouped(bytes),
                    percent(bytes, header.byte_count),
                    tool::fixed(static_cast<double>(bytes) / triangles, 1)});
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    add("<i class=\"key p" + std::to_string(i) + "\"></i>" + parts[i].name, parts[i].use,
        parts[i].bytes);
  }
  add("the image", "", header.byte_count);
  return "<h3>Bytes</h3>\n" + bar(parts, header.byte_count) +
         table("<span class=hide>Bytes by part</span>",
               {{"part", false}, {"bytes", true}, {"share", true}, {"per triangle", true}}, rows);
}

}  // namespace flashbvh::report
