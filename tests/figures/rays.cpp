// Rays at links: single ones aimed at a link's box from outside, and a row of them from one point,
// each with the hit before as hint; and points in the box. A hint must not change an answer.
#include "flashbvh/ray.hpp"

#include "costs.hpp"
#include "flashbvh/solid.hpp"
#include "links.hpp"
#include "support/random.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20240607;
constexpr uint32_t kOfLink = 128;  ///< aimed rays, and points
constexpr int32_t kOfLine = 256;   ///< rays of a row, 45 degrees wide

/// A mesh's box, in its frame.
struct MeshBox {
  Point lower;
  Point upper;

  explicit MeshBox(const Mesh& mesh) {
    const flashbvh::Box root = unpack(mesh.nodes[0].box);
    const int32_t(&o)[3] = mesh.origin;
    lower = {root.lower.x + o[0], root.lower.y + o[1], root.lower.z + o[2]};
    upper = {root.upper.x + o[0], root.upper.y + o[1], root.upper.z + o[2]};
  }
  Point middle() const {
    return {(lower.x + upper.x) / 2, (lower.y + upper.y) / 2, (lower.z + upper.z) / 2};
  }
  int32_t longest_side() const {
    const int32_t x = upper.x - lower.x;
    const int32_t y = upper.y - lower.y;
    const int32_t z = upper.z - lower.z;
    const int32_t of_xy = x < y ? y : x;
    return of_xy < z ? z : of_xy;
  }
  bool holds(const Point& p) const {
    return lower.x <= p.x && p.x <= upper.x && lower.y <= p.y && p.y <= upper.y && lower.z <= p.z &&
           p.z <= upper.z;
  }
};

Point any_point(test::Random& random, const Point& lower, const Point& upper) {
  const int32_t x = random.between(lower.x, upper.x);
  const int32_t y = random.between(lower.y, upper.y);
  return {x, y, random.between(lower.z, upper.z)};
}

/// A segment through `by` and equally far beyond it.
Segment through(const Point& from, const Point& by) {
  return {from, {2 * by.x - from.x, 2 * by.y - from.y, 2 * by.z - from.z}};
}

/// A random segment from outside the box, within two of its longest sides, through a point of it.
Segment any_aimed(test::Random& random, const MeshBox& box) {
  const int32_t reach = 2 * box.longest_side();
  const Point m = box.middle();
  Point from = m;
  while (box.holds(from)) {
    from = any_point(random, {m.x - reach, m.y - reach, m.z - reach},
                     {m.x + reach, m.y + reach, m.z + reach});
  }
  return through(from, any_point(random, box.lower, box.upper));
}

/// Ray `i` of the row whose origin lies one longest side away along each axis.
Segment of_line(const MeshBox& box, int32_t i) {
  const int32_t side = box.longest_side();
  const Point m = box.middle();
  const int32_t along = side * (2 * i - kOfLine + 1) / (2 * kOfLine);
  return through({m.x - side, m.y - side, m.z + side}, {m.x + along, m.y - along, m.z});
}

/// Adds a call of the set.
template <class Run>
auto add(const char* what, const char* set, const Run& run) {
  decltype(run()) answer = {};
  measure({{"ray", what, set}}, [&] { answer = run(); });
  add_to_digest(answer.visits);
  return answer;
}

bool measure_aimed(const Mesh& mesh, const Segment& segment) {
  const char* const set = any_hit(mesh, segment).yes ? "aimed" : "missed";
  const auto cold = add("cold", set, [&] { return nearest_hit(mesh, segment); });
  const auto any = add("any", set, [&] { return any_hit(mesh, segment); });
  measure({{"ray", "crossings", set}}, [&] { (void)signed_crossings(mesh, segment); });
  return cold.status == Status::done && any.yes == cold.yes;
}

/// Each ray that hits gets the previous hit as hint; the others leave the hint unchanged.
bool measure_line(const Mesh& mesh, const MeshBox& box) {
  bool right = true;
  uint16_t seed = kNoHint<uint16_t>;
  for (int32_t i = 0; i < kOfLine; ++i) {
    const Segment segment = of_line(box, i);
    const auto found = nearest_hit(mesh, segment);
    if (found.yes) {
      const auto hint = add("hint", "line", [&] { return nearest_hit(mesh, segment, seed); });
      right = right && hint.yes && hint.hit.triangle == found.hit.triangle;
      seed = found.hit.slot;
    }
  }
  return right;
}

}  // namespace

bool measure_rays() {
  const Mesh* const links[] = {kPairs[0].a, kPairs[1].a, kPairs[0].b, kPairs[3].b};
  test::Random random(kSeed);
  test::Random random_points(kSeed);
  bool right = true;
  for (const Mesh* const link : links) {
    const MeshBox box(*link);
    for (uint32_t i = 0; i < kOfLink; ++i) {
      right = measure_aimed(*link, any_aimed(random, box)) && right;
    }
    for (uint32_t i = 0; i < kOfLink; ++i) {
      const Point point = any_point(random_points, box.lower, box.upper);
      right = add("inside", nullptr, [&] { return inside(*link, point); }).status == Status::done &&
              right;
    }
    right = measure_line(*link, box) && right;
  }
  return right;
}

}  // namespace figures
