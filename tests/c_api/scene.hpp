// Random meshes and poses in both languages, and rows that call both.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "support/c_pose.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

/// A random mesh's image, opened in both languages.
struct Object {
  std::vector<std::uint32_t> image;
  Mesh mesh{};
  flashbvh_mesh c{};

  /// A few random triangles, or a closed torus.
  Object(Random& random, double cell);
  std::size_t size() const { return image.size() * sizeof image[0]; }
};

/// Inputs of a row.
struct Scene {
  explicit Scene(Random& from);

  Random& random;
  Object a;
  Object b;                            ///< sometimes of another cell, or not open
  std::vector<std::uint32_t> damaged;  ///< memory for a's image, and an extra word
  Pose pose;                           ///< sometimes an impossible one
  flashbvh_pose c_pose;
  std::uint32_t distance;  ///< sometimes too large

  /// A budget that suspends a query, or none.
  std::uint32_t any_work() { return random.below(4) == 0 ? UINT32_MAX : 1 + random.below(60); }
  /// A random point near the meshes, in cells.
  Point any_point();
};

/// C functions and their C++ counterparts on one scene; `agree` allocates nothing.
struct Row {
  const char* name;
  bool (*agree)(Scene& scene);
};

std::vector<Row> pair_rows();
std::vector<Row> distance_rows();
std::vector<Row> body_rows();

/// A bit for each status, and for each outcome of a first contact, that both languages returned.
extern std::uint64_t seen_statuses;
extern std::uint32_t seen_outcomes;

inline bool same(flashbvh_status c, Status status) {
  seen_statuses |= std::uint64_t{1} << c;
  return c == static_cast<flashbvh_status>(status);
}
inline bool same(const RunResult& c, const RunResult& step) {
  return same(static_cast<flashbvh_status>(c.status), step.status) && c.count == step.count &&
         c.work == step.work;
}
/// A call that decides: `yes` is what it wrote.
inline bool same(flashbvh_status c, bool yes, const Answer& answer) {
  return same(c, answer.status) && yes == answer.yes;
}
/// For types without padding.
template <class Plain>
bool same(const Plain& p, const Plain& q) {
  static_assert(__has_unique_object_representations(Plain), "padding has any bytes");
  return std::memcmp(&p, &q, sizeof p) == 0;
}
template <class Plain>
bool same(const Plain* p, const Plain* q, std::size_t count) {
  return std::memcmp(p, q, count * sizeof *p) == 0;
}
inline bool same(const Contact& p, const Contact& q) {
  return same(p.ends, q.ends) && same(p.normal_a, q.normal_a) && same(p.normal_b, q.normal_b) &&
         p.kind == q.kind;
}
bool same(const flashbvh_clearance& c, const Clearance<std::uint16_t>& known);

/// Overwrites a query's bytes, like a loss of power.
template <class Struct>
void wipe(Struct& object) {
  std::memset(&object, 0xA5, sizeof object);
}

}  // namespace flashbvh::test
