#include "small_tree.hpp"

#include "flashbvh/detail/bounds/slab.hpp"
#include "flashbvh/detail/lattice/box_packed.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"

namespace digest {

using namespace flashbvh;
using namespace flashbvh::detail;

namespace {

uint32_t cut(Shape shape, uint32_t count) {
  switch (shape) {
    case Shape::halves:
      return count / 2;
    case Shape::thirds:
      return (count + 2) / 3;
    case Shape::first_alone:
      return 1;
    default:
      return count - 1;
  }
}

/// Ids of triangles, from 0 on, and the vertex of the only shell.
constexpr uint16_t kIds[kMostTriangles] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                                           14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27};

uint16_t nodes_of(uint32_t leaves) {
  return static_cast<uint16_t>(2 * leaves - 1);
}

/// 1 to 126: four steps per octave of the sum of extents.
uint32_t rank_of(const PackedBox& box) {
  const uint32_t size = extent_x(box) + extent_y(box) + extent_z(box) + 4;
  uint32_t octave = 0;
  while ((size >> octave) >= 8) {
    ++octave;
  }
  return 1 + 4 * octave + ((size >> octave) & 3u);
}

}  // namespace

template <Layout layout>
PackedBox SmallTree<layout>::box_of(const SmallMesh& mesh, uint32_t first, uint32_t end) const {
  Box box = {{INT16_MAX, INT16_MAX, INT16_MAX}, {INT16_MIN, INT16_MIN, INT16_MIN}};
  const auto take = [](int16_t value, int16_t& lower, int16_t& upper) {
    lower = value < lower ? value : lower;
    upper = value > upper ? value : upper;
  };
  for (uint32_t i = leaf_offsets_[first]; i < leaf_offsets_[end]; ++i) {
    for (const uint16_t corner : mesh.triangles[i].corner) {
      const Vertex& v = mesh.vertices[corner];
      take(v.x, box.lower.x, box.upper.x);
      take(v.y, box.lower.y, box.upper.y);
      take(v.z, box.lower.z, box.upper.z);
    }
  }
  return pack(box);
}

/// Along the plane of the leaf's first triangle, and across its longest edge.
template <Layout layout>
void SmallTree<layout>::set_slabs(const SmallMesh& mesh, uint32_t leaf) {
  const auto at = [&](uint32_t triangle, int i) {
    return PackedVector::of(mesh.vertices[mesh.triangles[triangle].corner[i]]);
  };
  const uint32_t first = leaf_offsets_[leaf];
  const PackedTriangle triangle = {at(first, 0), at(first, 1), at(first, 2)};
  PackedVector direction[2] = {{0, 0}, {0, 0}};
  if (triangle.plane_direction(direction[0])) {
    (void)triangle.edge_direction(direction[0], direction[1]);
  }
  LeafSlabs& slabs = this->slabs()[leaf];
  for (int i = 0; i < 2; ++i) {
    const auto part = [](int32_t component) { return static_cast<int8_t>(component * 127 / 8192); };
    slabs.of[i] = {part(direction[i].x()), part(direction[i].y()), part(direction[i].z), 0};
    slabs.least[i] = 0;
    Slab slab;
    slab.begin(BakedSlab::of(slabs, i));
    Extent extent = {INT32_MAX / 2, INT32_MIN / 2};
    for (uint32_t t = first; t < leaf_offsets_[leaf + 1]; ++t) {
      for (int corner = 0; corner < 3; ++corner) {
        const int32_t along = dot(slab.direction(), at(t, corner));
        extent = {along < extent.least ? along : extent.least,
                  along > extent.most ? along : extent.most};
      }
    }
    slabs.least[i] = static_cast<int16_t>(extent.least >> kSlabUnitBits);
    const int32_t most = ((extent.most - 1) >> kSlabUnitBits) + 1;
    uint32_t thickness = static_cast<uint32_t>(most - slabs.least[i]);
    uint32_t exponent = 0;
    while (thickness > 31) {
      thickness = (thickness + 3) / 4;
      ++exponent;
    }
    slabs.of[i].thickness = static_cast<uint8_t>(exponent << 5 | thickness);
  }
}

/// `sibling`: the node of the parent's other child.
template <Layout layout>
void SmallTree<layout>::set_node(const SmallMesh& mesh, const Range& range, uint16_t sibling) {
  Node<uint16_t>& node = nodes_[range.node];
  const bool root = range.node == 0;
  const uint32_t leaves = static_cast<uint32_t>(range.end - range.first);
  node.box = box_of(mesh, range.first, range.end);
  levels_[range.node] = root ? uint16_t{0} : static_cast<uint16_t>(levels_[range.parent] + 1);
  const auto after = static_cast<uint16_t>(range.node + nodes_of(leaves));
  if (kPost) {
    node.link = root ? after : sibling;
    climb_[range.node] =
        range.last_child ? static_cast<uint16_t>(climb_[range.parent] + 1) : uint16_t{0};
  } else {
    node.link = after;
    climb_[range.node] = range.parent;
  }
  if (leaves == 1) {
    node.data = static_cast<uint16_t>(Node<uint16_t>::kLeafFlag | range.first);
    return;
  }
  const auto above = static_cast<uint32_t>(root ? kRootParentRank : nodes_[range.parent].rank());
  const uint32_t own = rank_of(node.box);
  node.data = static_cast<uint16_t>((own < above ? own : above < 127 ? above : 126u) << 8 | above);
}

template <Layout layout>
bool SmallTree<layout>::make(const SmallMesh& mesh, Shape shape, uint32_t leaf_size) {
  const uint32_t leaf_count = (mesh.triangle_count + leaf_size - 1) / leaf_size;
  for (uint32_t i = 0; i <= leaf_count; ++i) {
    const uint32_t first = i * leaf_size;
    leaf_offsets_[i] =
        static_cast<uint16_t>(first < mesh.triangle_count ? first : mesh.triangle_count);
  }
  Range pending[kMostTriangles];
  uint16_t siblings[kMostTriangles];
  uint32_t count = 0;
  pending[count] = {0, 0, 0, static_cast<uint16_t>(leaf_count), false};
  siblings[count++] = 0;
  while (count != 0) {
    --count;
    const Range range = pending[count];
    set_node(mesh, range, siblings[count]);
    if (range.end - range.first == 1) {
      continue;
    }
    const auto middle = static_cast<uint16_t>(
        range.first + cut(shape, static_cast<uint32_t>(range.end - range.first)));
    // Nodes and leaves have the same order: the subtree right after its parent takes the first
    // leaves. It is the first child or, in a post-indexed tree, the last one.
    const auto near = static_cast<uint16_t>(range.node + 1);
    const auto far =
        static_cast<uint16_t>(near + nodes_of(static_cast<uint32_t>(middle - range.first)));
    pending[count] = {far, range.node, middle, range.end, !kPost};
    siblings[count++] = near;
    pending[count] = {near, range.node, range.first, middle, kPost};
    siblings[count++] = far;
  }

  view_.nodes = nodes_;
  view_.triangles = mesh.triangles;
  view_.triangle_ids = kIds;
  view_.leaf_offsets = leaf_size == 1 ? nullptr : leaf_offsets_;
  const bool has_slabs = kPost && mesh.triangle_count % 2 != 0 && leaf_count <= kMostSlabs;
  for (uint32_t i = 0; has_slabs && i < leaf_count; ++i) {
    set_slabs(mesh, i);
  }
  view_.slabs = has_slabs ? slabs() : nullptr;
  view_.vertices = mesh.vertices;
  view_.node_count = nodes_of(leaf_count);
  view_.leaf_count = static_cast<uint16_t>(leaf_count);
  view_.triangle_count = mesh.triangle_count;
  view_.vertex_count = mesh.vertex_count;
  for (int i = 0; i < 3; ++i) {
    view_.origin[i] = mesh.origin[i];
  }
  view_.shell_vertices = kIds;
  view_.shell_count = 1;
  view_.unit = Unit::none;
  view_.is_closed = false;
  view_.deviation_sixteenths = 0;
  view_.cell_bits = 0x3FF0000000000000u;
  view_.levels = levels_;
  if constexpr (kPost) {
    view_.right_child_levels = climb_;
  } else {
    view_.parents = climb_;
  }
  TreeShape measured;
  const bool good = check_tree(view_, {levels_, climb_}, measured) == Status::done;
  view_.stack_need = static_cast<uint16_t>(measured.stack_need);
  view_.longest_edge = static_cast<uint16_t>(measured.longest_edge);
  return good;
}

template class SmallTree<Layout::pre_indexed>;
template class SmallTree<Layout::post_indexed>;

}  // namespace digest
