// Queries about distance, compiled once.
#include "flashbvh/clearance.hpp"

namespace flashbvh {

template <class MeshType>
void BasicClearanceQuery<MeshType>::take(const Seed& pair) {
  Triangle of_a;
  Triangle of_b;
  get_pair(pair.a, pair.b, of_a, of_b);
  (void)this->test(of_a, of_b, pair.a, pair.b);
}

template <class MeshType>
void BasicClearanceQuery<MeshType>::descend(uint32_t& work) {
  // Of a node with more children the first ones: a step takes bounded time.
  constexpr uint32_t kMostChildren = 8;
  const auto& node_a = this->mesh_a().nodes[this->nearest_a];
  const auto& node_b = this->mesh_b().nodes[this->nearest_b];
  if (node_a.is_leaf() && node_b.is_leaf()) {
    detail::take_work(work, detail::kTrianglePairWork);
    take({static_cast<Index>(this->mesh_a().first_triangle(node_a.leaf())),
          static_cast<Index>(this->mesh_b().first_triangle(node_b.leaf()))});
    return;
  }
  const bool into_a = node_a.rank() >= node_b.rank();
  const Mesh& mesh = into_a ? this->mesh_a() : this->mesh_b();
  Index& place = into_a ? this->nearest_a : this->nearest_b;
  const uint32_t parent = place;
  const auto go_down = [&](auto&& gap) {
    uint32_t child = mesh.first_child(parent);
    uint32_t nearest = UINT32_MAX;
    for (uint32_t i = 0; i < kMostChildren; ++i) {
      const auto& box = mesh.nodes[child].box;
      const uint32_t squared = into_a ? gap.squared(box, node_b.box) : gap.squared(node_a.box, box);
      this->count_visit();
      detail::take_work(work, 1);
      if (squared < nearest || i == 0) {
        nearest = squared;
        place = static_cast<Index>(child);
      }
      if (mesh.is_last_child(parent, child)) {
        break;
      }
      child = mesh.next_sibling(child);
    }
  };
  const detail::GapLimit any(INT64_MAX);
  if (this->transform().is_rotated()) {
    go_down(detail::RotatedGap(this->transform().rotated(), any));
  } else {
    go_down(detail::TranslatedGap(this->transform().translated().offset, any));
  }
}

template <class MeshType>
Status BasicClearanceQuery<MeshType>::resume(const ClearancePosition<Index>& position) {
  if (this->error() != Status::done) {
    return this->error();
  }
  const Seed& pair = position.witness;
  if (!position.has_witness) {
    if (position.walk.state != detail::State::fresh || pair.a >= this->mesh_a().node_count ||
        pair.b >= this->mesh_b().node_count) {
      return Status::position_invalid;
    }
    static_cast<Question&>(*this) = question(this->allowance);
    this->nearest_a = pair.a;
    this->nearest_b = pair.b;
    return Base::resume(position.walk);
  }
  if (pair.a >= this->mesh_a().triangle_count || pair.b >= this->mesh_b().triangle_count) {
    return Status::position_invalid;
  }
  const Status resumed = Base::resume(position.walk);
  if (resumed != Status::position_invalid) {
    static_cast<Question&>(*this) = question(this->allowance);
    take(pair);
  }
  return resumed == Status::position_invalid ? resumed : status();
}

template <class MeshType>
Clearance<typename MeshType::Index> BasicClearanceQuery<MeshType>::result() const {
  Clearance<Index> known{};
  known.status = status();
  known.in_range = this->error() == Status::done && this->transform().is_in_range();
  known.upper = UINT32_MAX;
  if (this->error() != Status::done || !has_witness()) {
    return known;
  }
  Triangle of_a;
  Triangle of_b;
  nearest_triangles(of_a, of_b);
  const NearestPoints nearest = nearest_points_of(of_a, of_b);
  known.lower = known.status == Status::done ? nearest.lower : 0;
  if (this->allowance != 0 && known.lower != 0) {
    const auto passed = static_cast<uint32_t>(
        detail::square_root(detail::shifted_up(detail::widened(this->limit + 1), 16)));
    known.lower = passed < known.lower ? passed : known.lower;
  }
  known.upper = nearest.upper;
  known.triangles = {this->mesh_a().triangle_ids[this->nearest_a],
                     this->mesh_b().triangle_ids[this->nearest_b]};
  known.witness = {this->nearest_a, this->nearest_b};
  known.point_a = nearest.point_a;
  known.point_b = nearest.point_b;
  known.direction = nearest.direction;
  return known;
}

template class Query<Ranked<PostMesh>, Within>;
template class Query<Ranked<LargePostMesh>, Within>;
template class BasicClearanceQuery<PostMesh>;
template class BasicClearanceQuery<LargePostMesh>;

}  // namespace flashbvh
