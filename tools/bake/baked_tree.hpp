// A tree laid out in arrays, ready to be written or queried.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bake/build_tree.hpp"
#include "bake/mesh.hpp"
#include "bake/surface.hpp"
#include "flashbvh/traversal/levels.hpp"

namespace flashbvh::bake {

/// The longest name of a mesh in an image, in bytes.
constexpr std::size_t kMaxNameSize = 255;

/// The arrays of BasicMeshWithLevels<Index, layout>, and what is known about them.
template <class IndexType, Layout layout>
struct BakedTree {
  using Index = IndexType;
  static constexpr Layout kLayout = layout;

  std::vector<Node<Index>> nodes;
  std::vector<Index> levels;
  std::vector<Index> climb;  ///< pre-indexed: parents; post-indexed: right child levels
  std::vector<Corners<Index>> triangles;
  std::vector<Index> triangle_ids;
  std::vector<Index> leaf_offsets;  ///< empty at one triangle per leaf
  std::vector<LeafSlabs> slabs;     ///< empty if pre-indexed, and for meshes that bend
  std::vector<Vertex> vertices;
  std::vector<Index> shell_vertices;

  std::uint32_t leaf_count = 0;
  std::uint32_t depth = 0;       ///< of the deepest leaf; the root has depth 0
  std::uint32_t stack_need = 0;  ///< Tree::stack_need
  std::uint32_t leaf_size = 0;   ///< most triangles in a leaf
  std::uint32_t arity = 0;       ///< most children of a node
  std::array<std::int32_t, 3> origin{};
  double cell = 1;
  double deviation = 0;
  std::uint16_t longest_edge = 0;
  bool is_closed = false;
  Unit unit = Unit::none;
  std::string name;  ///< at most kMaxNameSize bytes

  /// [array position]: the node of the BuildTree. Not written to any file.
  std::vector<std::uint32_t> build_nodes;

  /// A view into these arrays.
  BasicMeshWithLevels<Index, layout> view() const;
};

/// The limits of an index type.
template <class Index>
struct IndexLimits {
  static constexpr std::uint32_t kMost =
      static_cast<Index>(~Index{0});  ///< nodes, triangles, vertices
  static constexpr std::uint32_t kMostLeaves = kMost / 2 + 1;
};

/// True if the tree and its mesh are within the limits of `Index`.
template <class Index>
bool fits_index(const BuildTree& tree, const LatticeMesh& mesh) {
  std::uint32_t leaves = 0;
  for (const BuildNode& node : tree.nodes) {
    leaves += node.is_leaf() ? 1 : 0;
  }
  constexpr std::uint32_t most = IndexLimits<Index>::kMost;
  return tree.nodes.size() <= most && mesh.triangles.size() <= most &&
         mesh.vertices.size() <= most && leaves <= IndexLimits<Index>::kMostLeaves;
}

/// Lays the tree out. Precondition: fits_index<Index>(tree, mesh).
template <class Index, Layout layout>
BakedTree<Index, layout> lay_out(const BuildTree& tree, const LatticeMesh& mesh);

/// Rotates the corners of a leaf's triangles so that is_quad() finds shared edges: a refit then
/// reads four vertices for two triangles.
template <class Index, Layout layout>
void show_quads(BakedTree<Index, layout>& baked);

/// KIND(Index, layout) for every kind of tree.
#define FLASHBVH_FOR_EACH_KIND(KIND)        \
  KIND(std::uint16_t, Layout::pre_indexed)  \
  KIND(std::uint16_t, Layout::post_indexed) \
  KIND(std::uint32_t, Layout::pre_indexed)  \
  KIND(std::uint32_t, Layout::post_indexed)

}  // namespace flashbvh::bake
