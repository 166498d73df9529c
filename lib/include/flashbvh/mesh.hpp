// Baked meshes and their bounding volume trees as constant arrays in flash.
//
// Both layouts of the paper put a node before its subtrees:
//   pre-indexed   node, first subtree, ..., last subtree   (section 7)
//   post-indexed  node, last subtree, ..., first subtree   (section 8.3: reverse post-order)
// A node has any number of children from 1 up; leaves lie at any depth.
//
// `link` is the one index that a node stores:
//   pre-indexed   the escape index (definitions 3.1 to 3.3 and 8.1)
//   post-indexed  a child before the last: its next sibling, which has a smaller index;
//                 the last child: its first sibling (itself if it is alone), which has not.
// So the children in a post-indexed tree form a ring: the first child of node i is the link of
// i + 1, its last child. A last child is recognised by its link. The root's link is the number of
// nodes in both layouts: the imaginary end node of definition 3.3.
//
// A leaf's `data` has the top bit set and holds the leaf's number in array order. An internal
// node's `data` holds its rank in the top byte (1 to 126) and its parent's rank in the low byte
// (127 at the root): see traversal/ranked.hpp.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/arch/packed.hpp"
#include "flashbvh/lattice.hpp"
#include "flashbvh/plain/results.h"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// The order of a node's subtrees in the array: see above.
enum class Layout : uint8_t { pre_indexed = 0, post_indexed = 1 };

/// The rank of the root's missing parent: above every real rank.
constexpr int32_t kRootParentRank = 127;
/// Ranks of internal nodes run from 1 to this.
constexpr int32_t kMaxRank = 126;

/// A node of a tree: 16 bytes with 16-bit indices, 20 with 32-bit ones.
template <class IndexType>
struct Node {
  using Index = IndexType;
  static constexpr unsigned kBits = 8 * sizeof(Index);
  static constexpr Index kLeafFlag = static_cast<Index>(Index{1} << (kBits - 1));

  PackedBox box;
  Index link;
  Index data;

  /// True if the node has triangles instead of children.
  constexpr bool is_leaf() const { return (data & kLeafFlag) != 0; }
  /// Returns a leaf's number in array order.
  constexpr Index leaf() const { return static_cast<Index>(data & ~kLeafFlag); }
  /// Returns 1 to 126 for an internal node, a negative number for a leaf.
  constexpr int32_t rank() const { return static_cast<int8_t>(data >> (kBits - 8)); }
  /// Returns the rank of an internal node's parent, kRootParentRank at the root.
  constexpr int32_t parent_rank() const { return static_cast<uint8_t>(data); }
};

/// Indices of a triangle's three vertices.
template <class Index>
struct Corners {
  Index corner[3];
};

/// Two slabs that hold all triangles of a leaf: one along its plane, one across an edge in it. A
/// slab is a range of products of a direction, scaled by 64, with coordinates. Directions of zeros
/// reject nothing. 12 bytes.
struct LeafSlabs {
  /// A direction, and the range's size along it.
  struct Direction {
    int8_t x, y, z;     ///< -127 to 127
    uint8_t thickness;  ///< (low 5 bits) << (2 * high 3 bits), in 2^kSlabUnitBits
  };
  Direction of[2];
  int16_t least[2];  ///< lower end of the range, in 2^kSlabUnitBits
};
/// The unit of such a range, as a power of 2: two cells at most.
constexpr unsigned kSlabUnitBits = 14;

/// True if `u` and `v`, in this order, share an edge: the last two corners of `u` are those of `v`
/// in reverse order. Such a quad's box needs only four vertices, so `flashbvh bake --deformable`
/// turns the triangles of a leaf this way.
template <class Index>
FLASHBVH_INLINE inline bool is_quad(const Corners<Index>& u, const Corners<Index>& v) {
  if constexpr (sizeof(Index) == sizeof(uint16_t)) {
    uint32_t edge_of_u;
    uint32_t edge_of_v;
    __builtin_memcpy(&edge_of_u, &u.corner[1], sizeof edge_of_u);
    __builtin_memcpy(&edge_of_v, &v.corner[1], sizeof edge_of_v);
    return edge_of_u == detail::swap_halves(edge_of_v);
  } else {
    return u.corner[1] == v.corner[2] && u.corner[2] == v.corner[1];
  }
}

/// A tree: a view of nodes, which must outlive it. All of it is constant, so any number of queries,
/// tasks and interrupts may share it.
template <class IndexType, Layout layout>
struct Tree {
  using Index = IndexType;
  static constexpr Layout kLayout = layout;

  const Node<Index>* nodes;  ///< node_count nodes, the root first
  Index node_count;
  Index leaf_count;
  Index stack_need;  ///< most pairs that a descent of this tree can leave on a stack

  /// Returns the first child of an internal node.
  uint32_t first_child(uint32_t node) const {
    return layout == Layout::pre_indexed ? node + 1 : nodes[node + 1].link;
  }
  /// Returns the sibling after a child that is not the last.
  uint32_t next_sibling(uint32_t node) const { return nodes[node].link; }
  /// True if `child`, whose parent is `parent`, is the last sibling.
  bool is_last_child(uint32_t parent, uint32_t child) const {
    return layout == Layout::pre_indexed ? nodes[child].link == nodes[parent].link
                                         : child == parent + 1;
  }
};

/// Baked as NAME_TREE_SIZE, for time_bound.hpp.
using TreeSize = flashbvh_tree_size;

/// A deviation of more than 65,534/16 cells, or an unknown one.
constexpr uint16_t kDeviationUnknown = 65'535;
/// Half the diagonal of a cell in 1/16 cell, rounded up: the deviation of rounding alone.
constexpr uint16_t kRoundingDeviation = 14;

/// The unit of the lengths in a mesh's file. Images hold these values.
enum class Unit : uint8_t { none = 0, nm, um, mm, cm, m, mil, inch, foot };
constexpr uint8_t kUnitCount = 9;

/// A baked mesh: a view of its tree and triangles, whose arrays must outlive it. 72 bytes with
/// 16-bit indices on a 32-bit core.
template <class IndexType, Layout layout>
struct BasicMesh : Tree<IndexType, layout> {
  using Index = IndexType;

  const Corners<Index>* triangles;  ///< triangle_count, in order of their leaves
  const Index* triangle_ids;        ///< triangle_count: each triangle's number in the source mesh
  const Index* leaf_offsets;  ///< leaf_count + 1: each leaf's first triangle; null if one per leaf
  const LeafSlabs* slabs;     ///< leaf_count; null: queries make them, as the triangles move
  const Vertex* vertices;     ///< vertex_count
  const Index* shell_vertices;  ///< shell_count: the first vertex of each shell, ascending
  Index triangle_count;
  Index vertex_count;
  Index shell_count;      ///< number of shells: parts of the surface that share no vertex
  uint16_t longest_edge;  ///< length of the longest edge in cells, rounded up
  int32_t origin[3];      ///< the vertices' origin: a lattice point, in cells
  Unit unit;
  bool is_closed;  ///< true if each edge is used as often in one direction as in the other
  /// Largest distance of a point of mesh or source from the other one: in 1/16 cell, rounded up.
  /// Rounding, simplifying and dropped triangles count. kDeviationUnknown: more, or unknown.
  uint16_t deviation_sixteenths;
  /// The cell's length in the unit, as the bits of an IEEE binary64. 0: the mesh is not open.
  uint64_t cell_bits;

  /// Returns the slot of the leaf's first triangle in `triangles`.
  uint32_t first_triangle(uint32_t leaf) const {
    return leaf_offsets == nullptr ? leaf : leaf_offsets[leaf];
  }
  /// Returns the slot after the leaf's last triangle.
  uint32_t end_triangle(uint32_t leaf) const {
    return leaf_offsets == nullptr ? leaf + 1 : leaf_offsets[leaf + 1];
  }
  /// Returns the number of triangles in the leaf.
  uint32_t triangles_in(uint32_t leaf) const {
    if (leaf_offsets == nullptr) {
      return 1;
    }
    const auto* const offset = leaf_offsets + leaf;
    return uint32_t{offset[1]} - offset[0];
  }
};

namespace detail {

/// The sign of a cell. A mesh whose cell has it is *unusable*: a refit of it is not done, or a
/// shape does not fit the lattice. No baked mesh's cell is negative.
constexpr uint64_t kUnusableCell = uint64_t{1} << 63;

/// True if a mesh or a robot has a cell, even an unusable one.
template <class Opened>
bool has_cell(const Opened& opened) {
  return static_cast<uint32_t>(opened.cell_bits >> 32) << 1 != 0;
}

/// True if a mesh or a robot has a cell that is not unusable.
template <class Opened>
bool is_usable(const Opened& opened) {
  return static_cast<int32_t>(opened.cell_bits >> 32) > 0;
}

/// True if a query may use two meshes together: their cells are equal, and both are usable.
template <class Mesh>
bool have_one_cell(const Mesh& a, const Mesh& b) {
  return a.cell_bits == b.cell_bits && is_usable(a);
}

/// The error of a mesh that is not usable, and of two meshes without one cell.
template <class Mesh>
Status cell_error(const Mesh& a, const Mesh& b) {
  return has_cell(a) && has_cell(b) ? Status::cell_mismatch : Status::not_open;
}
template <class Mesh>
Status cell_error(const Mesh& mesh) {
  return cell_error(mesh, mesh);
}

}  // namespace detail

using PreTree = Tree<uint16_t, Layout::pre_indexed>;
using PostTree = Tree<uint16_t, Layout::post_indexed>;

using PreMesh = BasicMesh<uint16_t, Layout::pre_indexed>;
using Mesh = BasicMesh<uint16_t, Layout::post_indexed>;
using PreMesh32 = BasicMesh<uint32_t, Layout::pre_indexed>;
using Mesh32 = BasicMesh<uint32_t, Layout::post_indexed>;

static_assert(sizeof(Node<uint16_t>) == 16, "the figure in the documents");
static_assert(sizeof(Node<uint32_t>) == 20, "the figure in the documents");

}  // namespace flashbvh
