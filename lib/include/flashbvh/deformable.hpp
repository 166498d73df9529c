// Deformable meshes: vertices and boxes in the caller's RAM, all else where it was baked.
//
// Move any vertices, refit(), and query: mesh() is a mesh like any other. Every query, traversal
// and shape takes it, on either side and under any pose. The leaves' triangles and the ranks stay
// as baked; they are valid for any vertices. A refit passes once backwards over the nodes, without
// a stack, and can be cut into slices like a query.
//
// From the first move of a vertex until a refit ends `done`, boxes and vertices disagree and no
// query may use the mesh. During a refit, queries and rays of it, with any mesh or itself, end with
// `cell_mismatch`, and inside() with `not_closed`. A query begun before a refit must not resume
// after it: DeformableQuery and its cursor detect that.
//
// RAM: 16 bytes a node and 6 a vertex (20 with 32-bit indices), and this object, 104 bytes on a
// 32-bit core. Stack of a refit: 176 bytes on a Cortex-M4 at -O2.
#pragma once

#include <stdint.h>

#include "flashbvh/detail/query/refit.hpp"
#include "flashbvh/mesh.hpp"
#include "flashbvh/pose.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

/// The result of a refit's run.
struct [[nodiscard]] RefitResult {
  /// `done`; `suspended`: run again; `not_open`: the baked mesh is not; `vertex_out_of_lattice`:
  /// move that vertex to coordinates within +-kMaxCoordinate and refit again. Until then no query
  /// may use the mesh.
  Status status;
  uint32_t vertex;  ///< the first vertex outside the lattice
  uint32_t work;    ///< work spent
};

/// `MeshType`: Mesh, or any other kind. The baked mesh's arrays and the caller's must outlive it.
/// Must not be copied while queries point to it.
template <class MeshType>
class BasicDeformableMesh {
 public:
  using Mesh = MeshType;
  using Index = typename Mesh::Index;

  /// Copies node_count nodes and vertex_count vertices of `baked` into `nodes` and `vertices`.
  BasicDeformableMesh(const Mesh& baked, Node<Index>* nodes, Vertex* vertices)
      : mesh_(baked), nodes_(nodes), vertices_(vertices) {
    if (!detail::has_cell(baked)) {
      return;
    }
    __builtin_memcpy(nodes, baked.nodes, sizeof(Node<Index>) * baked.node_count);
    __builtin_memcpy(vertices, baked.vertices, sizeof(Vertex) * baked.vertex_count);
    mesh_.nodes = nodes;
    mesh_.vertices = vertices;
    mesh_.slabs = nullptr;
    is_closed_ = baked.is_closed;
  }

  /// Returns the mesh, for queries.
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// Returns the vertices, relative to the origin. Move any of them, then refit().
  [[nodiscard]] Vertex* vertices() { return vertices_; }

  /// Sets the vertices' origin, in cells of the mesh's frame, within +-2^29 along each axis: the
  /// lattice of a mesh moves with it. Then refit().
  void set_origin(const Point& origin) {
    mesh_.origin[0] = origin.x;
    mesh_.origin[1] = origin.y;
    mesh_.origin[2] = origin.z;
  }

  /// Fits the boxes to the current vertices. `work`: number of nodes; UINT32_MAX: no limit. After
  /// `suspended` the next call resumes. If vertices move meanwhile, call start_again().
  RefitResult refit(uint32_t work = UINT32_MAX);
  /// Discards the current refit; the next one starts from the beginning.
  void start_again() { node_ = 0; }

  /// Returns a version: odd while a refit is not done; no value repeats within 2^31 refits.
  [[nodiscard]] uint32_t refits() const { return refits_; }

 private:
  void begin();
  RefitResult end(uint32_t work);

  Mesh mesh_;
  Node<Index>* nodes_;
  Vertex* vertices_;
  uint32_t refits_ = 0;
  uint32_t node_ = 0;  ///< the next node plus 1; 0: no refit is in progress
  detail::RefitPlace place_ = {};
  bool is_closed_ = false;
};

using DeformableMesh = BasicDeformableMesh<Mesh>;

/// A DeformableQuery's cursor between runs; rejected after one of its meshes was refit.
template <class Index>
struct DeformableCursor {
  QueryCursor<Index> at;
  uint32_t refits;  ///< sum of both meshes' refits()
};

/// Any query in slices (PairQuery, SelfQuery, ClearanceQuery, ...) with one or two deformable
/// meshes. After a refit it ends with `mesh_changed`, and so does a resumed query.
///
///     DeformableQuery<PairQuery> query(link, cloth, pose);
template <class Query>
class DeformableQuery {
  using Mesh = typename Query::Mesh;
  using Index = typename Mesh::Index;
  using Deformable = BasicDeformableMesh<Mesh>;

 public:
  using Pair = TrianglePair<typename Mesh::Index>;

  /// Two deformable meshes, then the query's other arguments: its pose first.
  template <class... With>
  DeformableQuery(const Deformable& a, const Deformable& b, const With&... with)
      : query_(a.mesh(), b.mesh(), with...), a_(&a), b_(&b), refits_(refits()) {}
  /// B is deformable.
  template <class... With>
  DeformableQuery(const Mesh& a, const Deformable& b, const With&... with)
      : query_(a, b.mesh(), with...), a_(nullptr), b_(&b), refits_(refits()) {}
  /// A is deformable.
  template <class... With>
  DeformableQuery(const Deformable& a, const Mesh& b, const With&... with)
      : query_(a.mesh(), b, with...), a_(&a), b_(nullptr), refits_(refits()) {}
  /// One deformable mesh against itself, then a band's predicate.
  template <class... With>
  explicit DeformableQuery(const Deformable& mesh, const With&... with)
      : query_(mesh.mesh(), with...), a_(&mesh), b_(nullptr), refits_(refits()) {}

  /// Rejects temporary meshes and poses, which would be gone before the first run.
  template <class... With>
  explicit DeformableQuery(const Deformable&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Mesh&&, const Deformable&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Deformable&, const Deformable&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Deformable&, const Mesh&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Mesh&, const Deformable&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Deformable&, const Deformable&, const Pose&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Deformable&, const Mesh&, const Pose&&, const With&...) = delete;
  template <class... With>
  DeformableQuery(const Mesh&, const Deformable&, const Pose&&, const With&...) = delete;

  /// True if a mesh was refit since the query was made, or its refit is not done.
  [[nodiscard]] bool is_outdated() const {
    return refits_ != refits() || is_being_refit(a_) || is_being_refit(b_);
  }
  /// Returns the query's own status, or `mesh_changed`.
  [[nodiscard]] Status status() const {
    return is_outdated() ? Status::mesh_changed : query_.status();
  }
  /// As the query's own run(), in each of its forms.
  template <class... Arguments>
  FLASHBVH_INLINE RunResult run(uint32_t work, Arguments&&... arguments) {
    if (is_outdated()) {
      return {Status::mesh_changed, 0, 0};
    }
    return query_.run(work, arguments...);
  }

  /// Returns the query, with its results. They do not hold for the current mesh once is_outdated()
  /// is true.
  [[nodiscard]] const Query& query() const { return query_; }

  /// Returns the cursor. Valid between runs.
  [[nodiscard]] DeformableCursor<Index> cursor() const { return {query_.cursor(), refits_}; }
  /// `mesh_changed`: the cursor is from before a refit. Else as Query::resume().
  Status resume(const DeformableCursor<Index>& cursor) {
    if (is_outdated() || cursor.refits != refits_) {
      return Status::mesh_changed;
    }
    return query_.resume(cursor.at);
  }

 private:
  static bool is_being_refit(const Deformable* mesh) {
    return mesh != nullptr && mesh->refits() % 2 != 0;
  }
  /// Returns the sum of both counts. Both only grow, so equal sums mean equal counts.
  uint32_t refits() const {
    return (a_ != nullptr ? a_->refits() : 0) + (b_ != nullptr ? b_->refits() : 0);
  }

  Query query_;
  const Deformable* a_;  ///< null: not deformable
  const Deformable* b_;
  uint32_t refits_;
};

template <class MeshType>
void BasicDeformableMesh<MeshType>::begin() {
  if (refits_ % 2 == 0) {
    ++refits_;
    mesh_.cell_bits |= detail::kUnusableCell;
    mesh_.is_closed = false;
  }
  node_ = mesh_.node_count;
  place_.leaf = mesh_.leaf_count;
}

template <class MeshType>
RefitResult BasicDeformableMesh<MeshType>::refit(uint32_t work) {
  if (!detail::has_cell(mesh_)) {
    return {Status::not_open, 0, 0};
  }
  if (node_ == 0) {
    begin();
  }
  const uint32_t spent = work < node_ ? work : node_;
  if (spent != 0) {
    const uint32_t last = node_ - spent;
    if (mesh_.leaf_offsets == nullptr) {
      detail::refit_nodes<true>(nodes_, last, node_, vertices_, mesh_, place_);
    } else {
      detail::refit_nodes<false>(nodes_, last, node_, vertices_, mesh_, place_);
    }
    node_ = last;
  }
  return node_ != 0 ? RefitResult{Status::suspended, 0, spent} : end(spent);
}

template <class MeshType>
RefitResult BasicDeformableMesh<MeshType>::end(uint32_t work) {
  const PackedBox& root = nodes_[0].box;
  if (!detail::is_in_lattice(root)) {
    uint32_t vertex = 0;
    while (detail::is_in_lattice(vertices_[vertex])) {
      ++vertex;
    }
    return {Status::vertex_out_of_lattice, vertex, work};
  }
  mesh_.longest_edge = detail::longest_edge_in(root);
  mesh_.is_closed = is_closed_;
  mesh_.cell_bits &= ~detail::kUnusableCell;
  ++refits_;
  return {Status::done, 0, work};
}

// Compiled once, in the library.
extern template class BasicDeformableMesh<Mesh>;

}  // namespace flashbvh
