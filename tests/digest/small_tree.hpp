// Baked trees in fixed arrays: no heap, no C++ library, so that the digest runs on the smallest
// core and on cores without C++ headers. Binary, of any form; both layouts; small.
//
// A separate implementation of the layouts.
#pragma once

#include <stdint.h>

#include "flashbvh/traversal/levels.hpp"

namespace digest {

constexpr uint32_t kMostTriangles = 28;
constexpr uint32_t kMostNodes = 2 * kMostTriangles - 1;
constexpr uint32_t kMostVertices = 3 * kMostTriangles;

/// Triangles with own or shared corners, in any order.
struct SmallMesh {
  flashbvh::Vertex vertices[kMostVertices];
  flashbvh::Corners<uint16_t> triangles[kMostTriangles];
  uint16_t vertex_count;
  uint16_t triangle_count;
  int32_t origin[3];
};

/// The division of a range of n leaves into two.
enum class Shape : uint8_t { halves, thirds, first_alone, last_alone };

/// A tree over a mesh, in the order of its triangles; the mesh outlives it.
template <flashbvh::Layout layout>
class SmallTree {
 public:
  using Tree = flashbvh::BasicMeshWithLevels<uint16_t, layout>;

  /// `leaf_size`: triangles in each leaf but the last. Trees of an odd number of triangles, in up
  /// to kMostSlabs leaves, have slabs. False if check_tree() refuses the tree.
  [[nodiscard]] bool make(const SmallMesh& mesh, Shape shape, uint32_t leaf_size);

  /// Points into this object and the mesh.
  const Tree& view() const { return view_; }

 private:
  /// Leaves from `first` to before `end` under node `node`, whose parent is `parent`.
  struct Range {
    uint16_t node, parent, first, end;
    bool last_child;
  };

  void set_slabs(const SmallMesh& mesh, uint32_t leaf);
  void set_node(const SmallMesh& mesh, const Range& range, uint16_t sibling);
  flashbvh::PackedBox box_of(const SmallMesh& mesh, uint32_t first, uint32_t end) const;

  static constexpr uint32_t kMostSlabs = 8;
  static constexpr bool kPost = layout == flashbvh::Layout::post_indexed;

  /// A small tree's slabs lie in the nodes that it does not use, for the smallest board's RAM.
  flashbvh::LeafSlabs* slabs() {
    return reinterpret_cast<flashbvh::LeafSlabs*>(nodes_ + 2 * kMostSlabs);
  }

  flashbvh::Node<uint16_t> nodes_[kMostNodes];
  uint16_t levels_[kMostNodes];
  uint16_t climb_[kMostNodes];
  uint16_t leaf_offsets_[kMostTriangles + 1];
  Tree view_;
};

}  // namespace digest
