#include "cli/bake_report.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

void print_row(const BakeResult& result, std::size_t width) {
  std::visit(
      [&](const auto& baked) {
        const double per_triangle =
            static_cast<double>(result.flash_bytes) / static_cast<double>(baked.triangles.size());
        std::cout << std::left << std::setw(static_cast<int>(width)) << result.name.stem
                  << std::right << std::setw(10) << baked.triangles.size() << std::setw(10)
                  << baked.vertices.size() << std::setw(8) << baked.nodes.size() << std::setw(7)
                  << baked.depth << std::setw(10) << result.flash_bytes << std::setw(16)
                  << fixed(per_triangle, 1) << std::setw(10) << result.image_bytes << "  "
                  << shortest(baked.deviation) << "\n";
      },
      result.baked.tree);
}

/// "kept; --drop degenerate leaves them out", or that they were.
std::string fate(bool dropped, const char* kind) {
  return dropped ? "; left out" : std::string("; kept (--drop ") + kind + " leaves them out)";
}

std::string edge_text(const EdgeDefects& edges) {
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count != 0) {
      text += (text.empty() ? "" : ", ") + std::to_string(count) +
              (count == 1 ? " edge " : " edges ") + what;
    }
  };
  add(edges.open, "of one triangle");
  add(edges.crowded, "of more than two");
  add(edges.twisted, "of two that face opposite ways");
  return text;
}

}  // namespace

void print_table(const std::vector<BakeResult>& results, const std::string& cell) {
  std::size_t width = 6;
  for (const BakeResult& result : results) {
    width = std::max(width, result.name.stem.size() + 2);
  }
  std::cout << std::left << std::setw(static_cast<int>(width)) << "mesh"
            << " triangles  vertices   nodes  depth     flash  bytes/triangle     image  largest "
               "deviation\n";
  for (const BakeResult& result : results) {
    print_row(result, width);
  }
  std::cout << "cell " << cell
            << "; flash: bytes that a query on the C++ output links; image: bytes of the binary\n";
}

void warn_of_defects(const MeshDefects& defects, const BakeOptions& options,
                     const std::string& path, Warnings& warnings) {
  const auto warn = [&](const TriangleNumbers& triangles, const char* what, bool dropped,
                        const char* kind) {
    if (!triangles.empty()) {
      warnings.add(path, what + triangle_list(triangles) + fate(dropped, kind));
    }
  };
  warn(defects.degenerate, "without area: ", options.drop_degenerate, "degenerate");
  warn(defects.collapsed, "without area once rounded: ", options.drop_degenerate, "degenerate");
  warn(defects.duplicates,
       "with the three vertices of an earlier one, once rounded: ", options.drop_duplicate,
       "duplicate");
  if (!defects.edges.none()) {
    warnings.add(path, std::string(defects.closed_before ? "once rounded " : "") +
                           "no closed surface (" + edge_text(defects.edges) +
                           "): what lies inside the solid can't be told" +
                           (defects.closed_before ? "; a finer --cell keeps it closed" : ""));
  }
}

}  // namespace flashbvh::tool
