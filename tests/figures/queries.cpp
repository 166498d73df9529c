// Collisions of links: all pairs and the first one, shapes, and the opening of images.
#include "bicep.fbvh.h"
#include "costs.hpp"
#include "flashbvh/collide.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/shape.hpp"
#include "links.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr auto kEveryPair = [](const PairQuery::Pair&) { return true; };
constexpr int32_t kHalfBox = 1000;  // cells

/// A box in the place of B, to A.
bool measure_box(const LinkPair& pair, const PoseKey& key, const Pose& pose) {
  BoxShape box(*pair.a, {0, 0, 0}, {1, 1, 1});
  const Point least = {-kHalfBox, -kHalfBox, -kHalfBox};
  const Point most = {kHalfBox, kHalfBox, kHalfBox};
  Answer answer{};
  measure({{"kr5", key.motion(), key.proximity_name(), "box"}}, [&] {
    box.set(least, most);
    answer = intersects(*pair.a, box.mesh(), pose);
  });
  add_to_digest(answer.yes ? 1 : 0);
  return answer.status == Status::done;
}

bool measure_pose(const LinkPair& pair, const PoseKey& key) {
  const Pose pose = key.pose();
  const auto name = [&key](const char* what) {
    return Name{{"kr5", key.motion(), key.proximity_name(), what}};
  };
  Status status{};
  measure(name("query"), [&] {
    PairQuery query(*pair.a, *pair.b, pose);
    status = query.run(UINT32_MAX, kEveryPair).status;
  });
  // Counts come from another run: a caller of the first run would not copy them.
  PairQuery query(*pair.a, *pair.b, pose);
  (void)query.run(UINT32_MAX, kEveryPair);
  add_count(name("visits"), query.stats().visits);
  add_to_digest(query.stats());
  bool one = query.stats().triangle_pairs != 0;
  const bool intersects_too = key.proximity == Proximity::intersecting;
  if (intersects_too) {
    measure(name("first"), [&] { one = intersects(*pair.a, *pair.b, pose).yes; });
  }
  return measure_box(pair, key, pose) && status == Status::done && one == intersects_too;
}

}  // namespace

bool measure_queries() {
  Mesh opened;
  Status status{};
  measure({{"kr5", "open_image"}},
          [&] { status = open_image(bicep_image, sizeof bicep_image, opened); });
  return for_each_pose(measure_pose) && status == Status::done;
}

}  // namespace figures
