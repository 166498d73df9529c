#include "flashbvh/baking.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "bake/build_tree.hpp"
#include "bake/quantise.hpp"
#include "flashbvh/numbers.hpp"
#include "flashbvh/user_error.hpp"

namespace flashbvh::tool {
namespace {

bool is_degenerate(const bake::LatticeMesh& mesh, const bake::TriangleCorners& triangle) {
  const Vertex& p = mesh.vertices[triangle[0]];
  const Vertex& q = mesh.vertices[triangle[1]];
  const Vertex& r = mesh.vertices[triangle[2]];
  const std::int64_t u[3] = {q.x - p.x, q.y - p.y, q.z - p.z};
  const std::int64_t v[3] = {r.x - p.x, r.y - p.y, r.z - p.z};
  return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
}

void count_oddities(const bake::LatticeMesh& mesh, BakedMesh& baked) {
  std::set<bake::TriangleCorners> seen;
  for (const bake::TriangleCorners& triangle : mesh.triangles) {
    baked.degenerate += is_degenerate(mesh, triangle) ? 1 : 0;
    bake::TriangleCorners sorted = triangle;
    std::sort(sorted.begin(), sorted.end());
    baked.repeated += seen.insert(sorted).second ? 0 : 1;
  }
}

/// What of the mesh or its tree is over the limit of 16-bit indices.
std::string too_many(const bake::LatticeMesh& mesh, const bake::BuildTree& tree) {
  constexpr std::size_t most = bake::IndexLimits<std::uint16_t>::kMost;
  const auto exceeds = [](std::size_t count, const char* what, std::size_t limit) {
    return std::to_string(count) + " " + what + ", but 16-bit indices reach " +
           std::to_string(limit);
  };
  if (mesh.triangles.size() > most) {
    return exceeds(mesh.triangles.size(), "triangles", most) +
           "; use --index-bits 32 or fewer triangles";
  }
  if (mesh.vertices.size() > most) {
    return exceeds(mesh.vertices.size(), "vertices", most) +
           "; use --index-bits 32 or fewer triangles";
  }
  constexpr const char* mend = "; use a larger --leaf-size or --index-bits 32";
  if (tree.nodes.size() > most) {
    return exceeds(tree.nodes.size(), "nodes", most) + mend;
  }
  const auto leaves = std::count_if(tree.nodes.begin(), tree.nodes.end(),
                                    [](const bake::BuildNode& node) { return node.is_leaf(); });
  return exceeds(static_cast<std::size_t>(leaves), "leaves",
                 bake::IndexLimits<std::uint16_t>::kMostLeaves) +
         mend;
}

template <class Index>
AnyBakedTree lay_out(const bake::BuildTree& tree, const bake::LatticeMesh& mesh, Layout layout) {
  if (layout == Layout::pre_indexed) {
    return bake::lay_out<Index, Layout::pre_indexed>(tree, mesh);
  }
  return bake::lay_out<Index, Layout::post_indexed>(tree, mesh);
}

}  // namespace

double finest_float_cell(const bake::SourceMesh& mesh) {
  return std::max(bake::finest_cell(mesh), static_cast<double>(std::numeric_limits<float>::min()));
}

BakedMesh bake_mesh(const bake::SourceMesh& mesh, double cell, const BakeOptions& options,
                    const std::string& path) {
  if (!bake::fits(mesh, cell)) {
    throw UserError(path, "the mesh is too large for a cell of " + shortest(cell) +
                              "; the finest that it fits is --cell " +
                              shortest(finest_float_cell(mesh)));
  }
  const bake::LatticeMesh lattice = bake::round_to_lattice(mesh, cell);
  bake::BuildTree tree = options.builder == Builder::median
                             ? bake::build_median(lattice, options.leaf_size)
                             : bake::build_sah(lattice, options.leaf_size);
  if (options.arity > 2) {
    tree = bake::collapse(tree, options.arity);
  }
  BakedMesh baked;
  if (options.index_bits == 16) {
    if (!bake::fits_index<std::uint16_t>(tree, lattice)) {
      throw UserError(path, too_many(lattice, tree));
    }
    baked.tree = lay_out<std::uint16_t>(tree, lattice, options.layout);
  } else {
    baked.tree = lay_out<std::uint32_t>(tree, lattice, options.layout);
  }
  count_oddities(lattice, baked);
  return baked;
}

}  // namespace flashbvh::tool
