// Distances against brute force, on trees that fit every board.
#include <initializer_list>

#include "flashbvh/clearance.hpp"
#include "support/rounds.hpp"
#include "support/small_scene.hpp"
#include "support/transformed_vertex.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

const int kRounds = rounds(100, 1000);

using Scene = SmallScene<Layout::post_indexed>;

template <class Visit>
void for_all_pairs(const Scene& scene, const Visit& visit) {
  const Mesh& a = scene.a.view();
  const Mesh& b = scene.b.view();
  test::for_all_pairs(a, b, transform_of_any(scene.pose, a, b), visit);
}

/// clearance_test.cpp tests scenes out of range.
bool is_in_range(const Scene& scene) {
  return !transform_of_any(scene.pose, scene.a.view(), scene.b.view()).is_beyond();
}

Fraction least_distance(const Scene& scene) {
  Fraction least = kInfinite;
  for_all_pairs(scene, [&](uint32_t, uint32_t, const Triangle& a, const Triangle& b) {
    Features features;
    (void)is_nearer(a, b, least, features);
  });
  return least;
}

PairSet brute_force_within(const Scene& scene, uint32_t distance) {
  PairSet pairs;
  const ShortFraction limit = {uint64_t{distance} * distance, 1 << 16};
  for_all_pairs(scene, [&](uint32_t i, uint32_t j, const Triangle& a, const Triangle& b) {
    if (is_within(a, b, limit)) {
      (void)pairs.add(scene.a.view().triangle_ids[i], scene.b.view().triangle_ids[j]);
    }
  });
  return pairs;
}

}  // namespace

TEST_CASE("small trees: the distance is that of the nearest triangles, however it is cut") {
  int apart = 0;
  for_rounds(kRounds, [&](Random& random, int) {
    const Scene scene(random);
    if (!is_in_range(scene)) {
      return;
    }
    const Fraction least = least_distance(scene);
    Witness<uint16_t> begin;
    for (const uint32_t work : {kNoLimit, uint32_t{1}, 1 + random.below(60)}) {
      ClearanceQuery query(scene.a.view(), scene.b.view(), scene.pose, begin);
      while (query.run(work).status == Status::suspended) {
      }
      const Clearance<uint16_t> found = query.result();
      REQUIRE(found.status == Status::done);
      REQUIRE(found.in_range);
      REQUIRE(found.lower == lower_of(least));
      Triangle a;
      Triangle b;
      query.nearest_triangles(a, b);
      Fraction squared = kInfinite;
      Features features;
      REQUIRE(is_nearer(a, b, squared, features));
      REQUIRE(compare(squared, least) == 0);
      begin = found.witness;
    }
    apart += is_zero(least.above) ? 0 : 1;
  });
  CHECK(apart > kRounds / 10);
}

TEST_CASE("small trees: within a distance are the pairs that brute force finds") {
  for_rounds(kRounds, [&](Random& random, int) {
    const Scene scene(random);
    if (!is_in_range(scene)) {
      return;
    }
    const uint32_t lower = lower_of(least_distance(scene));
    for (const uint32_t more : {uint32_t{0}, uint32_t{1}, random.below(1 << 16)}) {
      const uint32_t reach = lower + more < kMaxDistance ? lower + more : kMaxDistance;
      WithinQuery query(scene.a.view(), scene.b.view(), scene.pose, {}, within({reach}));
      const bool exact =
          all_pairs(query, 1 + random.below(100)) == brute_force_within(scene, reach);
      REQUIRE(exact);
    }
  });
}
