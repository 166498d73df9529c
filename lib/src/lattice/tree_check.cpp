// Checks that queries on a tree stay in bounds and terminate.
//
// The check visits nodes in array order, in which a node precedes its subtree. After an internal
// node comes its child (the first in a pre-indexed tree, the last in a post-indexed one). After a
// leaf comes a sibling of the leaf or of an ancestor, found by climbing. Each node is entered and
// left once, so the pass is linear. It reads only checked values, so it is safe on any bytes; it
// keeps a few words of state.
//
// A post-indexed tree needs only its links: a node's link is the sibling that precedes it in array
// order. A pre-indexed tree is climbed by its parents.
#include "flashbvh/detail/arch/inline.hpp"
#include "flashbvh/detail/lattice/baked_slab.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "surface.hpp"

#pragma GCC diagnostic ignored "-Weffc++"  // some members are set after construction

namespace flashbvh::detail {
namespace {

/// True if no bound lies beyond the lattice. Leaves' boxes contain triangles and other boxes a
/// child's box, so no bound is 0 and no lower bound is above its upper bound.
bool is_on_lattice(const PackedBox& box) {
  return ((box.upper_xy | box.lower_xy | box.z) & 0x80008000u) == 0;
}

/// For boxes on the lattice: their halves have a spare bit, so packed differences do not borrow.
bool is_inside(const PackedBox& inner, const PackedBox& outer) {
  constexpr uint32_t spare = 0x80008000u;
  const uint32_t reach = ((outer.upper_xy | spare) - inner.upper_xy) &
                         ((outer.lower_xy | spare) - inner.lower_xy) &
                         ((outer.z | spare) - inner.z);
  return (reach & spare) == spare;
}

template <class Index, Layout layout>
class Checker {
  static constexpr bool kPre = layout == Layout::pre_indexed;

 public:
  /// The check writes to `shape` while it runs.
  Checker(const BasicMesh<Index, layout>& tree, const ImageLevels<Index>& levels, TreeShape& shape)
      : tree_(tree), levels_(levels), leaves_(0), shape_(shape) {
    shape = {0, 0, 0, 0, 0, false};
  }

  bool check() {
    if (!vertices_on_lattice() || !root() || !node(0)) {
      return false;
    }
    for (uint32_t i = 1; i < tree_.node_count; ++i) {
      const bool entered = tree_.nodes[i - 1].is_leaf() ? enter_sibling(i) : enter_child(i);
      if (!entered || !node(i)) {
        return false;
      }
    }
    uint32_t last = tree_.node_count - 1u;
    if (!tree_.nodes[last].is_leaf() || !leave_to(last, 0, tree_.node_count) ||
        leaves_ != tree_.leaf_count || tree_.first_triangle(leaves_) != tree_.triangle_count ||
        !shells()) {
      return false;
    }
    measure_children();
    shape_.longest_edge = surface_.longest_edge();
    shape_.is_closed = surface_.is_closed();
    return true;
  }

 private:
  FLASHBVH_NOINLINE bool vertices_on_lattice() const {
    for (uint32_t i = 0; i < tree_.vertex_count; ++i) {
      const Vertex& v = tree_.vertices[i];
      const int16_t coordinates[3] = {v.x, v.y, v.z};
      for (const int16_t c : coordinates) {
        if (c < -kMaxCoordinate || c > kMaxCoordinate) {
          return false;
        }
      }
    }
    return true;
  }

  bool root() const {
    const Node<Index>& node = tree_.nodes[0];
    const bool rank = node.is_leaf() || node.parent_rank() == kRootParentRank;
    const bool levels = !has_levels() || (level(0) == 0 && climb(0) == 0);
    return node.link == tree_.node_count && rank && levels;
  }

  /// Checks that there are shells and that their vertices ascend; does not search their triangles.
  FLASHBVH_NOINLINE bool shells() const {
    if (tree_.shell_count == 0) {
      return false;
    }
    for (uint32_t i = 0; i < tree_.shell_count; ++i) {
      const uint32_t vertex = tree_.shell_vertices[i];
      if (vertex >= tree_.vertex_count || (i != 0 && vertex <= tree_.shell_vertices[i - 1])) {
        return false;
      }
    }
    return true;
  }

  bool has_levels() const { return kPre || levels_.levels != nullptr; }
  uint32_t level(uint32_t node) const { return levels_.levels[node]; }
  /// Pre-indexed: the parent; post-indexed: the right child level.
  uint32_t climb(uint32_t node) const { return levels_.climb[node]; }

  /// Checks a node by itself, without its parent.
  bool node(uint32_t i) {
    const Node<Index>& node = tree_.nodes[i];
    return is_on_lattice(node.box) && (node.is_leaf() ? leaf(node) : has_ranks(node));
  }

  /// Checks that a node's data holds two ranks, with zeros between them.
  static bool has_ranks(const Node<Index>& node) {
    constexpr Index ends = static_cast<Index>((Index{0xFF} << (Node<Index>::kBits - 8)) | 0xFF);
    return node.rank() >= 1 && node.rank() <= kMaxRank && (node.data & ends) == node.data;
  }

  /// Checks that leaves and their triangles ascend in array order, and that the box contains them.
  bool leaf(const Node<Index>& node) {
    if (node.leaf() != leaves_ || leaves_ == tree_.leaf_count) {
      return false;
    }
    const uint32_t first = tree_.first_triangle(leaves_);
    const uint32_t end = tree_.end_triangle(leaves_);
    if (first >= end || end > tree_.triangle_count || end - first > kMaxLeafSize ||
        (leaves_ == 0 && first != 0)) {
      return false;
    }
    shape_.leaf_size = greater(shape_.leaf_size, end - first);
    for (uint32_t i = first; i < end; ++i) {
      if (!triangle(i, node.box)) {
        return false;
      }
    }
    if (tree_.slabs != nullptr && !slabs(tree_.slabs[leaves_], first, end)) {
      return false;
    }
    ++leaves_;
    return true;
  }

  /// True if no sum with this slab leaves 32 bits.
  static bool is_in_range(const LeafSlabs::Direction& d, int32_t least) {
    constexpr int32_t most = 1 << (29 - kSlabUnitBits);
    return d.x != INT8_MIN && d.y != INT8_MIN && d.z != INT8_MIN &&
           least + ((d.thickness & 31) << 2 * (d.thickness >> 5)) <= most;
  }

  /// Checks that both slabs of a leaf hold its triangles.
  FLASHBVH_NOINLINE bool slabs(const LeafSlabs& slabs, uint32_t first, uint32_t end) const {
    for (int which = 0; which < 2; ++which) {
      if (!is_in_range(slabs.of[which], slabs.least[which])) {
        return false;
      }
      const BakedSlab within = BakedSlab::of(slabs, which);
      const Index* const corner_end = tree_.triangles[end].corner;
      for (const Index* corner = tree_.triangles[first].corner; corner != corner_end; ++corner) {
        const int32_t along = dot(within.direction, PackedVector::of(tree_.vertices[*corner]));
        if (along < within.least || along > within.most) {
          return false;
        }
      }
    }
    return true;
  }

  FLASHBVH_NOINLINE bool triangle(uint32_t position, const PackedBox& box) {
    const Index(&corner)[3] = tree_.triangles[position].corner;
    const uint32_t u = corner[0];
    const uint32_t v = corner[1];
    const uint32_t w = corner[2];
    if (u >= tree_.vertex_count || v >= tree_.vertex_count || w >= tree_.vertex_count) {
      return false;
    }
    const Vertex p = tree_.vertices[u];
    const Vertex q = tree_.vertices[v];
    const Vertex r = tree_.vertices[w];
    surface_.add(u, v, w, p, q, r);
    return is_inside(pack({p, p}), box) && is_inside(pack({q, q}), box) &&
           is_inside(pack({r, r}), box);
  }

  /// Node i follows the internal node i - 1 and must be its child.
  bool enter_child(uint32_t i) const {
    if (has_levels() && level(i) != level(i - 1) + 1) {
      return false;
    }
    if constexpr (kPre) {
      return climb(i) == i - 1;
    } else {
      return tree_.nodes[i].link >= i && (!has_levels() || climb(i) == climb(i - 1) + 1);
    }
  }

  /// Node i follows the leaf i - 1 and must be a sibling of a node above it, or of the leaf itself.
  bool enter_sibling(uint32_t i) const {
    uint32_t sibling = i - 1;
    if constexpr (kPre) {
      return leave_to(sibling, level(i), i) && sibling != 0 && climb(i) == climb(sibling);
    } else {
      const uint32_t link = tree_.nodes[i].link;
      return link < i && leave_to(sibling, link, i) &&
             (!has_levels() || (level(i) == level(link) && climb(i) == 0));
    }
  }

  /// Climbs from `node` to its ancestor at `place`: a level of a pre-indexed tree, an index of a
  /// post-indexed one. Checks each parent on the way, whose children are then complete. `next` is
  /// the next node in array order: in a pre-indexed tree, all nodes that are left must link to it.
  bool leave_to(uint32_t& node, uint32_t place, uint32_t next) const {
    if (kPre && tree_.nodes[node].link != next) {
      return false;
    }
    while (place_of(node) > place) {
      uint32_t parent;
      if constexpr (kPre) {
        parent = climb(node);
        if (tree_.nodes[parent].link != next) {
          return false;
        }
      } else {
        const uint32_t last = last_sibling(node);
        if (tree_.nodes[last].link != node) {
          return false;
        }
        parent = last - 1;
      }
      if (!children_belong_to(parent)) {
        return false;
      }
      node = parent;
    }
    return place_of(node) == place;
  }

  uint32_t place_of(uint32_t node) const { return kPre ? level(node) : node; }

  uint32_t last_sibling(uint32_t node) const {
    while (tree_.nodes[node].link < node) {
      node = tree_.nodes[node].link;
    }
    return node;
  }

  FLASHBVH_NOINLINE bool children_belong_to(uint32_t parent) const {
    const Node<Index>& above = tree_.nodes[parent];
    for (uint32_t child = tree_.first_child(parent);; child = tree_.next_sibling(child)) {
      const Node<Index>& node = tree_.nodes[child];
      const bool ranks =
          node.is_leaf() || (node.parent_rank() == above.rank() && node.rank() <= above.rank());
      if (!ranks || !is_inside(node.box, above.box)) {
        return false;
      }
      if (tree_.is_last_child(parent, child)) {
        return true;
      }
    }
  }

  /// Measures depth, stack need and arity. The tree's links must be checked.
  FLASHBVH_NOINLINE void measure_children() {
    uint32_t pending = 0;
    uint32_t depth = 0;
    for (uint32_t i = 1; i < tree_.node_count; ++i) {
      uint32_t above = i - 1;
      if (tree_.nodes[above].is_leaf()) {
        while (!are_siblings(above, i)) {
          above = parent_of(above);
          pending -= later_siblings(above);
          --depth;
        }
      } else {
        const uint32_t more = later_siblings(above);
        shape_.arity = greater(shape_.arity, more + 1);
        pending += more;
        ++depth;
      }
      shape_.stack_need = greater(shape_.stack_need, pending);
      shape_.depth = greater(shape_.depth, depth);
    }
  }

  /// `above`: the leaf before `node`, or an ancestor of that leaf.
  bool are_siblings(uint32_t above, uint32_t node) const {
    return kPre ? level(above) == level(node) : tree_.nodes[node].link == above;
  }

  static uint32_t greater(uint32_t u, uint32_t v) { return u > v ? u : v; }

  /// Number of a node's children, less one.
  uint32_t later_siblings(uint32_t parent) const {
    uint32_t count = 0;
    for (uint32_t child = tree_.first_child(parent); !tree_.is_last_child(parent, child);
         child = tree_.next_sibling(child)) {
      ++count;
    }
    return count;
  }

  uint32_t parent_of(uint32_t node) const {
    if constexpr (kPre) {
      return climb(node);
    } else {
      return last_sibling(node) - 1;
    }
  }

  const BasicMesh<Index, layout>& tree_;
  const ImageLevels<Index>& levels_;
  uint32_t leaves_;  ///< number of leaves checked
  Surface surface_;  ///< of these leaves' triangles
  TreeShape& shape_;
};

}  // namespace

template <class Index, Layout layout>
Status check_tree(const BasicMesh<Index, layout>& mesh, const ImageLevels<Index>& levels,
                  TreeShape& shape) {
  return Checker<Index, layout>(mesh, levels, shape).check() ? Status::done : Status::image_invalid;
}

template Status check_tree(const PreMesh&, const ImageLevels<uint16_t>&, TreeShape&);
template Status check_tree(const Mesh&, const ImageLevels<uint16_t>&, TreeShape&);
template Status check_tree(const PreMesh32&, const ImageLevels<uint32_t>&, TreeShape&);
template Status check_tree(const Mesh32&, const ImageLevels<uint32_t>&, TreeShape&);

}  // namespace flashbvh::detail
