#include "cloth.hpp"

using namespace flashbvh;

namespace cloth {
namespace {

constexpr int kStretches = 8;
constexpr float kAir = 0.98f;
constexpr float kFriction = 0.6f;  ///< the share of its last movement that a touching point loses
constexpr float kFirm = 0.7f;
constexpr float kGentle = 0.4f;  ///< share of the missing distance per pair: many push one point

constexpr Vector kHere = {0, 0, 0};

int16_t rounded(float at) {
  constexpr int32_t up = 2 * kMaxCoordinate;
  const float raised = at + static_cast<float>(up) + 0.5f;
  const float most = static_cast<float>(4 * kMaxCoordinate);
  return static_cast<int16_t>(static_cast<int32_t>(raised < 0      ? 0
                                                   : raised > most ? most
                                                                   : raised) -
                              up);
}

}  // namespace

Vector from(const Vertex& v, const Vector& offset) {
  return {static_cast<float>(v.x) + offset.x, static_cast<float>(v.y) + offset.y,
          static_cast<float>(v.z) + offset.z};
}

Cloth::Cloth(const Mesh& rest, const Setting& setting, Vector* points, Vector* before)
    : rest_(rest), setting_(setting), points_(points), before_(before) {
  for (uint32_t i = 0; i < rest.vertex_count; ++i) {
    before_[i] = points_[i] = from(rest.vertices[i], kHere);
  }
}

void Cloth::step() {
  for (uint32_t i = 0; i < rest_.vertex_count; ++i) {
    Vector way = kAir * (points_[i] - before_[i]);
    way.z -= setting_.weight;
    const float squared = dot(way, way);
    const float most = setting_.most * setting_.most;
    way = squared > most ? (setting_.most / __builtin_sqrtf(squared)) * way : way;
    before_[i] = points_[i];
    points_[i] = points_[i] + way;
  }
  for (int i = 0; i < kStretches; ++i) {
    for (uint32_t t = 0; t < rest_.triangle_count; ++t) {
      const auto& corner = rest_.triangles[t].corner;
      stretch(corner[0], corner[1]);
      stretch(corner[1], corner[2]);
      stretch(corner[2], corner[0]);
    }
  }
  for (uint32_t i = 0; i < rest_.vertex_count; ++i) {
    if (points_[i].z < setting_.floor) {
      points_[i].z = setting_.floor;
      before_[i] = points_[i] - (1 - kFriction) * (points_[i] - before_[i]);
    }
  }
}

/// Approximates the root of the length by Newton's first step from the length at rest.
void Cloth::stretch(uint32_t u, uint32_t v) {
  const Vector rest = from(rest_.vertices[u], kHere) - from(rest_.vertices[v], kHere);
  const float squared = dot(rest, rest);
  const Vector along = points_[u] - points_[v];
  const Vector moved = (squared / (dot(along, along) + squared) - 0.5f) * along;
  points_[u] = points_[u] + moved;
  points_[v] = points_[v] - moved;
}

void Cloth::push_off(uint32_t position, const Vector& on_plane, const Vector& normal) {
  for (const uint32_t i : rest_.triangles[position].corner) {
    const float missing = setting_.thickness - dot(points_[i] - on_plane, normal);
    if (missing > 0) {
      points_[i] = points_[i] + (kFirm * missing) * normal;
      before_[i] = before_[i] + (kFriction * kFirm) * (points_[i] - before_[i]);
    }
  }
}

Vector Cloth::normal_of(uint32_t position) const {
  const auto& corner = rest_.triangles[position].corner;
  const Vector& o = points_[corner[0]];
  const Vector n = cross(points_[corner[1]] - o, points_[corner[2]] - o);
  const float squared = dot(n, n);
  return squared > 0 ? (1 / __builtin_sqrtf(squared)) * n : kHere;
}

Vector Cloth::middle_of(uint32_t position) const {
  const auto& corner = rest_.triangles[position].corner;
  return (1 / 3.0f) * (points_[corner[0]] + points_[corner[1]] + points_[corner[2]]);
}

void Cloth::push_apart(uint32_t a, uint32_t b) {
  Vector normal = normal_of(a);
  float height = dot(middle_of(b) - middle_of(a), normal);
  if (height < 0) {
    normal = -1.0f * normal;
    height = -height;
  }
  const float missing = setting_.thickness - height;
  if (missing <= 0) {
    return;
  }
  const Vector half = (0.5f * kGentle * missing) * normal;
  for (int i = 0; i < 3; ++i) {
    const uint32_t of_a = rest_.triangles[a].corner[i];
    const uint32_t of_b = rest_.triangles[b].corner[i];
    points_[of_a] = points_[of_a] - half;
    points_[of_b] = points_[of_b] + half;
  }
}

void Cloth::put_into(Vertex* vertices) const {
  for (uint32_t i = 0; i < rest_.vertex_count; ++i) {
    const Vector& p = points_[i];
    vertices[i] = {rounded(p.x), rounded(p.y), rounded(p.z)};
  }
}

}  // namespace cloth
