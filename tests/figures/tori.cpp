// Two tori in random poses, and pairs of triangles of the most expensive kinds: measurements that
// need no robot's meshes.
#include "measure.hpp"

#include "flashbvh/image.hpp"
#include "support/rotations.hpp"
#include "support/triangle_kinds.hpp"
#include "thick.fbvh.h"
#include "thin.fbvh.h"

using namespace flashbvh;
using namespace flashbvh::detail;

namespace figures {
namespace {

const Mesh thick = view_unchecked<Mesh>(thick_image);
const Mesh thin = view_unchecked<Mesh>(thin_image);

constexpr uint64_t kSeed = 20240607;
constexpr int32_t kReaches[] = {2000, 6000, 12000};
constexpr uint32_t kPosesOfReach = 20;

Pose any_pose(test::Random& random, int32_t reach, bool rotated) {
  if (rotated) {
    return test::any_rigid_pose(random, reach);
  }
  const int32_t x = random.between(-reach, reach);
  const int32_t y = random.between(-reach, reach);
  return Pose::translated(x, y, random.between(-reach, reach));
}

bool measure_tori(bool rotated) {
  test::Random random(kSeed);
  bool right = true;
  for (const int32_t reach : kReaches) {
    for (uint32_t i = 0; i < kPosesOfReach; ++i) {
      QueryStats counts{};
      uint32_t work = 0;
      const FigureNames names = {"tori", rotated ? "rotated" : "translated", nullptr};
      right =
          add_query(names, thick, thin, any_pose(random, reach, rotated), counts, work) && right;
    }
  }
  return right;
}

void measure_kind(const test::TriangleKind& kind) {
  constexpr uint32_t kPairs = 300;
  test::Random random(kSeed);
  uint32_t intersecting = 0;
  for (uint32_t i = 0; i < kPairs; ++i) {
    Triangle a;
    Triangle b;
    test::set_random_pair(random, kind, a, b);
    bool intersects = false;
    measure({{"triangles", kind.name}}, [&] { intersects = triangles_intersect(a, b); });
    intersecting += intersects ? 1 : 0;
  }
  add_count({{"triangles", kind.name, "intersecting"}}, intersecting);
}

}  // namespace
}  // namespace figures

int main() {
  const bool translated = figures::measure_tori(false);
  const bool rotated = figures::measure_tori(true);
  for (const auto& kind : flashbvh::test::kTriangleKinds) {
    figures::measure_kind(kind);
  }
  return figures::print_all("tori", translated && rotated);
}
