// Rays at the KR5's links: single ones aimed at a link's box from outside, and scans of it, fans of
// rays from one point; and points in the box. Exits with 1 if a hint changes an answer, or
// any_hit() and nearest_hit() disagree.
#include "flashbvh/ray.hpp"

#include "bicep.fbvh.h"
#include "flashbvh/image.hpp"
#include "flashbvh/solid.hpp"
#include "forearm.fbvh.h"
#include "palm.fbvh.h"
#include "ray_sets.hpp"
#include "report.hpp"
#include "wrist.fbvh.h"

using namespace flashbvh;

namespace figures {
namespace {

const Mesh bicep = view_unchecked<Mesh>(bicep_image);
const Mesh forearm = view_unchecked<Mesh>(forearm_image);
const Mesh palm = view_unchecked<Mesh>(palm_image);
const Mesh wrist = view_unchecked<Mesh>(wrist_image);

constexpr uint64_t kSeed = 20240607;
constexpr uint32_t kOfLink = 128;  ///< aimed rays, and points
constexpr uint16_t kNone = kNoHint<uint16_t>;

constexpr Fan kFans[] = {{"grid", 16, 16}, {"line", 1, 256}};

const Mesh* const kLinks[] = {&bicep, &forearm, &palm, &wrist};

/// The cost of a visit, with nothing rejected, and of a triangle that nearest_hit() reaches:
/// loading and testing it.
void add_parts(const Mesh& mesh, const Segment& segment, const char* set) {
  detail::SegmentWalk<Mesh> all(mesh, segment);
  uint32_t position = 0;
  const uint32_t instructions = port::instructions_of([&] {
    while (all.next_triangle(position)) {
    }
  });
  add_quotient({{"ray", "visit"}}, instructions, all.visits());

  detail::SegmentWalk<Mesh> walk(mesh, segment);
  RayHit<uint16_t> hit = {};
  SegmentShare nearest = {1, 1};
  uint32_t count = 0;
  while (walk.next_triangle(position)) {
    bool yes = false;
    measure({{"ray", "triangle"}}, [&] { yes = walk.get_hit(position, hit); });
    ++count;
    if (yes && order_along(hit.along, nearest) < 0) {
      nearest = hit.along;
      walk.shorten(nearest);
    }
  }
  add_count({{"ray", "triangles", set}}, count);
}

/// Adds a query of the set.
template <class Run>
auto add(const char* what, const char* set, const Run& run) {
  decltype(run()) answer = {};
  measure({{"ray", what, set}}, [&] { answer = run(); });
  add_count({{"ray", "visits", what, set}}, answer.visits);
  return answer;
}

/// Returns whether the answers agree.
bool measure_ray(const char* set, const Mesh& mesh, const Segment& segment, uint16_t seed) {
  const auto cold = add("cold", set, [&] { return nearest_hit(mesh, segment); });
  const auto hint = add("hint", set, [&] { return nearest_hit(mesh, segment, seed); });
  const auto any = add("any", set, [&] { return any_hit(mesh, segment); });
  measure({{"ray", "crossings", set}}, [&] { (void)signed_crossings(mesh, segment); });
  add_parts(mesh, segment, set);
  return cold.status == Status::done && hint.yes == cold.yes && any.yes == cold.yes &&
         (!cold.yes || hint.hit.triangle == cold.hit.triangle);
}

bool measure_aimed() {
  test::Random random(kSeed);
  bool good = true;
  for (const Mesh* const link : kLinks) {
    const Box box(*link);
    for (uint32_t i = 0; i < kOfLink; ++i) {
      const Segment segment = any_aimed(random, box);
      const char* const set = any_hit(*link, segment).yes ? "aimed" : "missed";
      good = measure_ray(set, *link, segment, kNone) && good;
    }
  }
  return good;
}

/// Each ray that hits gets the previous hit as hint; the others leave the hint unchanged.
bool measure_fan(const Fan& fan) {
  bool good = true;
  for (const Mesh* const link : kLinks) {
    const Box box(*link);
    uint16_t seed = kNone;
    for (int32_t i = 0; i < fan.rows * fan.columns; ++i) {
      const Segment segment = of_fan(fan, box, i / fan.columns, i % fan.columns);
      const auto found = nearest_hit(*link, segment);
      if (found.yes) {
        good = measure_ray(fan.name, *link, segment, seed) && good;
        seed = found.hit.slot;
      }
    }
  }
  return good;
}

bool measure_points() {
  test::Random random(kSeed);
  bool good = true;
  for (const Mesh* const link : kLinks) {
    const Box box(*link);
    for (uint32_t i = 0; i < kOfLink; ++i) {
      const Point point = any_point(random, box.lower, box.upper);
      good = add("inside", nullptr, [&] { return inside(*link, point); }).status == Status::done &&
             good;
    }
  }
  return good;
}

}  // namespace
}  // namespace figures

int main() {
  bool good = figures::measure_aimed();
  for (const figures::Fan& fan : figures::kFans) {
    good = figures::measure_fan(fan) && good;
  }
  good = figures::measure_points() && good;
  return figures::print_all("ray", good);
}
