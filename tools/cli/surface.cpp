#include "cli/surface.hpp"

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string edge_text(const EdgeDefects& edges) {
  std::string text;
  const auto add = [&](std::size_t count, const char* kind, const char* what) {
    if (count != 0) {
      text += concat((text.empty() ? "" : ", "), count, " ", kind,
                     (count == 1 ? "edge " : "edges "), what);
    }
  };
  add(edges.boundary, "boundary ", "of one triangle");
  add(edges.non_manifold, "non-manifold ", "of more than two");
  add(edges.twisted, "", "of two that face opposite ways");
  return text;
}

}  // namespace

void warn_of_surface(const MeshDefects& defects, const std::string& path, Warnings& warnings) {
  if (!defects.edges.none()) {
    warnings.add(path, std::string(defects.closed_before ? "once rounded " : "") +
                           "no closed surface (" + edge_text(defects.edges) +
                           "): what lies inside the solid can't be told" +
                           (defects.edges.twisted != 0 ? ", nor which way normals face" : "") +
                           (defects.closed_before ? "; a finer --cell keeps it closed" : ""));
  }
  if (defects.inside_out) {
    warnings.add(path,
                 "is inside out: normals face into the solid; turn the triangles round in the "
                 "program that made it");
  }
}

}  // namespace flashbvh::tool
