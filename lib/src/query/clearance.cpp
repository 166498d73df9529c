// Distance queries, with their explicit instantiations.
#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/predicates/triangle.hpp"

namespace flashbvh {
namespace {

/// Limits that bound the time of a step: more triangles of a leaf, or children of a node, are
/// skipped.
constexpr uint32_t kMostTaken = 2;
constexpr uint32_t kMostChildren = 8;

/// Clamps to UINT32_MAX.
uint32_t saturated(uint64_t value) {
  return value < UINT32_MAX ? static_cast<uint32_t>(value) : UINT32_MAX;
}

/// Upper bound on how far Transform::place_far() moves a B that is out of range; in 1/256 cell,
/// saturates at UINT32_MAX.
uint32_t brought_near(const Pose& pose, const int32_t (&origin_a)[3],
                      const int32_t (&origin_b)[3]) {
  // Covers the fractions of the offset and of the rounded vertices.
  const int64_t rounded = pose.is_translation() ? 0 : 3;
  detail::Int128 squared = {0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    int64_t turned = 0;  // in 2^-30 cell; below 2^60
    for (int column = 0; column < 3; ++column) {
      turned += int64_t{pose.rotation(axis, column)} * origin_b[column];
    }
    const int64_t cells = (turned >> 30) + pose.translation(axis) - origin_a[axis];
    const int64_t beyond = (cells < 0 ? -cells : cells) + rounded - detail::kMaxFarOffset;
    squared = beyond > 0 ? squared + detail::full_product(beyond, beyond) : squared;
  }
  const uint64_t length = detail::square_root(detail::shifted_up(squared, 16));
  return saturated(detail::is_zero(squared) ? 0 : length + 1);
}

}  // namespace

template <class MeshType>
void BasicClearanceQuery<MeshType>::begin_at(const Pose& pose, const Hint& hint) {
  const Mesh& a = this->mesh_a();
  const Mesh& b = this->mesh_b();
  if (this->error() != Status::done) {
    return;
  }
  if (this->transform().is_beyond()) {
    this->beyond = brought_near(pose, a.origin, b.origin);
  }
  if (hint.is_none()) {
    return;
  }
  if (!detail::is_pair(hint, a, b)) {
    this->refuse(Status::hint_invalid);
    return;
  }
  const int64_t gap = begin_with(hint);
  if (gap != 0 && is_stale(gap)) {
    this->has_nearest = false;
    this->nearest_a = 0;
    this->nearest_b = 0;
  }
}

template <class MeshType>
bool BasicClearanceQuery<MeshType>::is_stale(int64_t squared_gap) const {
  const detail::Transform& transform = this->transform();
  if (transform.is_far()) {
    return false;
  }
  const auto& root_a = this->mesh_a().nodes[0].box;
  const auto& root_b = this->mesh_b().nodes[0].box;
  const detail::GapLimit any(INT64_MAX);
  const uint32_t guess =
      transform.is_rotated()
          ? detail::RotatedGap(transform.rotated(), any).guess(root_a, root_b)
          : detail::WideGap(transform.translated().offset, any).guess(root_a, root_b);
  // Guesses are in units of 4 cells. A share of each mesh's size is added because one mesh may lie
  // inside the other.
  const auto part = [](const PackedBox& root) {
    const uint32_t fours = detail::extent(root) >> 5;
    return int64_t{fours} * fours;
  };
  return squared_gap >> 3 > int64_t{guess} + part(root_a) + part(root_b);
}

template <class MeshType>
void BasicClearanceQuery<MeshType>::get_pair(uint32_t i, uint32_t j, Triangle (&pair)[2]) const {
  detail::translate_triangle(this->mesh_a(), i, detail::kNoOffset, pair[0]);
  detail::transform_any_triangle(this->mesh_b(), j, this->transform(), pair[1]);
}

template <class MeshType>
int64_t BasicClearanceQuery<MeshType>::begin_with(const Hint& pair) {
  Triangle of[2];
  get_pair(pair.a, pair.b, of);
  this->nearest_a = pair.a;
  this->nearest_b = pair.b;
  this->has_nearest = true;
  this->has_features = false;
  const int64_t gap = detail::squared_box_gap(of[0], of[1]);
  this->intersect = gap == 0 && detail::triangles_intersect(of[0], of[1]);
  return gap;
}

template <class MeshType>
bool BasicClearanceQuery<MeshType>::take(uint32_t i, uint32_t j) {
  Triangle pair[2];
  get_pair(i, j, pair);
  if (!Predicate::take(pair[0], pair[1])) {
    return false;
  }
  this->nearest_a = static_cast<Index>(i);
  this->nearest_b = static_cast<Index>(j);
  return true;
}

template <class MeshType>
FLASHBVH_INLINE inline void BasicClearanceQuery<MeshType>::take_leaves(uint32_t& work) {
  const Mesh& mesh_a = this->mesh_a();
  const Mesh& mesh_b = this->mesh_b();
  const uint32_t leaf_a = mesh_a.nodes[this->nearest_a].leaf();
  const uint32_t leaf_b = mesh_b.nodes[this->nearest_b].leaf();
  const auto count = [](uint32_t triangles) {
    return triangles < kMostTaken ? triangles : kMostTaken;
  };
  const uint32_t in_a = count(mesh_a.triangles_in(leaf_a));
  const uint32_t in_b = count(mesh_b.triangles_in(leaf_b));
  for (uint32_t b = 0; b < in_b; ++b) {
    for (uint32_t a = 0; a < in_a && !this->intersect; ++a) {
      detail::take_work(work, detail::kTrianglePairWork);
      ++this->tested;
      (void)take(mesh_a.first_triangle(leaf_a) + a, mesh_b.first_triangle(leaf_b) + b);
    }
  }
}

template <class MeshType>
Status BasicClearanceQuery<MeshType>::run_within(uint32_t& work) {
  if (status() != Status::suspended || work == 0) {
    return status();
  }
  if (!this->is_made()) {
    return Status::not_open;
  }
  this->prepare();
  detail::NearestSoFar known(this->transform());
  const uint32_t kept = this->beyond;
  this->so_far = &known;
  if (this->has_nearest) {
    ++this->tested;
    (void)take(this->nearest_a, this->nearest_b);
  }
  while (!this->has_nearest && work != 0) {
    if (!descend(work)) {
      take_leaves(work);
      if (may_be_coarse()) {
        set_coarse(true);
      }
    }
  }
  while (!this->intersect && work != 0) {
    const Status walked = this->run_with(
        work,
        [this](const TrianglePair<Index>&) {
          const TrianglePair<Index> at = this->last_slots();
          if (!take(at.a, at.b)) {
            this->uncount_pair();
          }
          return !this->intersect;
        },
        [] { return UINT32_MAX; });
    if (walked != Status::done || !this->is_coarse) {
      break;
    }
    this->restart();
    set_coarse(false);
  }
  this->beyond = kept;
  return status();
}

/// Changes the limit, and what depends on it.
template <class MeshType>
void BasicClearanceQuery<MeshType>::set_coarse(bool coarse) {
  this->is_coarse = coarse;
  Triangle pair[2];
  get_pair(this->nearest_a, this->nearest_b, pair);
  this->so_far->limit = this->limit_of(this->so_far->least);
  this->so_far->turn(pair[0], pair[1], this->features());
}

/// True if a coarse walk may find a pair much nearer than the descent did: the roots' boxes are so
/// near.
template <class MeshType>
bool BasicClearanceQuery<MeshType>::may_be_coarse() const {
  const detail::Transform& transform = this->transform();
  if (this->intersect || transform.is_far()) {
    return false;
  }
  const auto& root_a = this->mesh_a().nodes[0].box;
  const auto& root_b = this->mesh_b().nodes[0].box;
  const detail::GapLimit limit(this->so_far->limit >> Predicate::kCoarse);
  return transform.is_rotated()
             ? detail::RotatedGap(transform.rotated(), limit)(root_a, root_b)
             : detail::WideGap(transform.translated().offset, limit)(root_a, root_b);
}

template <class MeshType>
bool BasicClearanceQuery<MeshType>::descend(uint32_t& work) {
  const auto& node_a = this->mesh_a().nodes[this->nearest_a];
  const auto& node_b = this->mesh_b().nodes[this->nearest_b];
  if (node_a.is_leaf() && node_b.is_leaf()) {
    return false;
  }
  const bool into_a = node_a.rank() >= node_b.rank();
  const Mesh& mesh = into_a ? this->mesh_a() : this->mesh_b();
  Index& place = into_a ? this->nearest_a : this->nearest_b;
  const auto& other = into_a ? node_b.box : node_a.box;
  const detail::Transform& transform = this->transform();
  const detail::GapLimit any(INT64_MAX);
  const detail::WideGap translated(transform.translated().offset, any);
  detail::RotatedGap rotated(transform.rotated(), any);
  const auto guess_of = [&](const PackedBox& of_a, const PackedBox& of_b) {
    return transform.is_far()       ? this->so_far->along.guess(of_a, of_b)
           : transform.is_rotated() ? rotated.guess(of_a, of_b)
                                    : translated.guess(of_a, of_b);
  };
  const uint32_t parent = place;
  uint32_t child = mesh.first_child(parent);
  uint32_t nearest = UINT32_MAX;
  for (uint32_t i = 0; i < kMostChildren; ++i) {
    const auto& box = mesh.nodes[child].box;
    const uint32_t guess = guess_of(into_a ? box : other, into_a ? other : box);
    this->count_visit();
    detail::take_work(work, 1);
    if (guess < nearest || i == 0) {
      nearest = guess;
      place = static_cast<Index>(child);
    }
    if (mesh.is_last_child(parent, child)) {
      break;
    }
    child = mesh.next_sibling(child);
  }
  return true;
}

template <class MeshType>
Status BasicClearanceQuery<MeshType>::resume(const QueryCursor<Index>& at) {
  if (this->error() != Status::done) {
    return this->error();
  }
  const Hint pair = {at.witness_a, at.witness_b};
  const bool found = at.has_witness != 0;
  this->is_coarse = at.has_witness == 2;
  const uint32_t most_a = found ? this->mesh_a().triangle_count : this->mesh_a().node_count;
  const uint32_t most_b = found ? this->mesh_b().triangle_count : this->mesh_b().node_count;
  if (pair.a >= most_a || pair.b >= most_b || (!found && at.state != detail::State::fresh)) {
    return Status::cursor_invalid;
  }
  const Status resumed = Base::resume(at);
  if (resumed == Status::cursor_invalid) {
    return resumed;
  }
  this->has_nearest = false;
  this->intersect = false;
  if (found) {
    (void)begin_with(pair);
  } else {
    this->nearest_a = pair.a;
    this->nearest_b = pair.b;
  }
  return status();
}

template <class MeshType>
Clearance<typename MeshType::Index> BasicClearanceQuery<MeshType>::result() const {
  Clearance<Index> known{};
  known.status = status();
  known.in_range = this->error() == Status::done && !this->transform().is_beyond();
  known.upper = UINT32_MAX;
  if (this->error() != Status::done || !this->has_nearest) {
    return known;
  }
  Triangle of_a;
  Triangle of_b;
  nearest_triangles(of_a, of_b);
  detail::Fraction squared = detail::kInfinite;
  detail::Features features = this->features();
  if (this->has_features) {
    squared = detail::squared_between(of_a, of_b, features);
  } else {
    (void)detail::is_nearer(of_a, of_b, squared, features);
  }
  NearestPoints nearest;
  detail::get_nearest_points(of_a, of_b, features, squared, nearest);
  known.lower = known.status == Status::done ? nearest.lower : 0;
  if (this->allowance != 0 && known.lower != 0) {
    const int64_t passed_over = detail::largest_below(squared, this->allowance) + 1;
    const auto passed = static_cast<uint32_t>(
        detail::square_root(detail::shifted_up(detail::widened(passed_over), 16)));
    known.lower = passed < known.lower ? passed : known.lower;
  }
  known.upper = saturated(uint64_t{nearest.upper} + this->beyond);
  if (!known.in_range) {
    return known;
  }
  known.triangles = {this->mesh_a().triangle_ids[this->nearest_a],
                     this->mesh_b().triangle_ids[this->nearest_b]};
  known.witness = {this->nearest_a, this->nearest_b};
  known.point_a = nearest.point_a;
  known.point_b = nearest.point_b;
  known.direction = nearest.direction;
  return known;
}

FLASHBVH_COMPILED_QUERY_RUN(, Ranked<Mesh>, Within);
FLASHBVH_COMPILED_QUERY_RUN(, Ranked<Mesh32>, Within);
template class Query<Ranked<Mesh>, Within>;
template class Query<Ranked<Mesh32>, Within>;
template class BasicClearanceQuery<Mesh>;
template class BasicClearanceQuery<Mesh32>;

}  // namespace flashbvh
