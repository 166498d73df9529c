// The traversal of a search for one pair, and the searches that use it: against brute force, on
// trees that fit every board, many of them chains deeper than the stored levels.
#include "flashbvh/collide.hpp"
#include "flashbvh/detail/walk/near_first.hpp"
#include "support/rounds.hpp"
#include "support/small_scene.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

const int kRounds = rounds(300, 2000);

using Near = Query<detail::NearFirst<Mesh>>;
using Hint = Witness<uint16_t>;
using Scene = SmallScene<Layout::post_indexed>;

bool holds(const Scene& scene, const Hint& hint) {
  return brute_force(scene).has(scene.a.view().triangle_ids[hint.a],
                                scene.b.view().triangle_ids[hint.b]);
}

}  // namespace

TEST_CASE("small trees: nearest first, a query finds exactly the pairs that brute force finds") {
  for_rounds(kRounds, [&](Random& random, int) {
    const Scene scene(random);
    const PairSet truth = brute_force(scene);
    Near whole(scene.a.view(), scene.b.view(), scene.pose);
    REQUIRE((all_pairs(whole) == truth));
    Near cut(scene.a.view(), scene.b.view(), scene.pose);
    REQUIRE((all_pairs(cut, 1 + random.below(60)) == truth));
    REQUIRE(whole.stats().visits == cut.stats().visits);
    REQUIRE(whole.stats().leaf_pairs == cut.stats().leaf_pairs);
  });
}

TEST_CASE("small trees: a first pair is one that intersects, if any does") {
  int found_some = 0;
  for_rounds(kRounds, 1, [&](Random& random, int) {
    const Scene scene(random);
    const PairSet truth = brute_force(scene);
    const bool expected = !(truth == PairSet());
    Pair found = {0xABCD, 0xDCBA};
    const Answer answer = first_pair<uint16_t>(scene.a.view(), scene.b.view(), scene.pose, found);
    REQUIRE(answer.status == Status::done);
    REQUIRE(answer.yes == expected);
    REQUIRE(intersects<uint16_t>(scene.a.view(), scene.b.view(), scene.pose).yes == expected);
    if (expected) {
      REQUIRE(truth.has(found.a, found.b));
      ++found_some;
    } else {
      REQUIRE(found.a == 0xABCD);
      REQUIRE(found.b == 0xDCBA);
    }
  });
  CHECK(found_some > kRounds / 10);
}

TEST_CASE("small trees: a hint never changes the answer, and is the pair that was found") {
  int kept = 0;
  int lost = 0;
  for_rounds(kRounds, 2, [&](Random& random, int) {
    const Scene scene(random);
    const Mesh& a = scene.a.view();
    const Mesh& b = scene.b.view();
    const bool expected = intersects(a, b, scene.pose).yes;
    Hint hint;
    const uint32_t kind = random.below(4);
    if (kind == 0) {
      (void)intersects(a, b, scene.pose, hint);
    } else if (kind != 1) {
      hint = {static_cast<uint16_t>(random.below(a.triangle_count)),
              static_cast<uint16_t>(random.below(b.triangle_count))};
    }
    const Hint before = hint;
    const bool held = !before.is_none() && holds(scene, before);
    const Answer answer = intersects(a, b, scene.pose, hint);
    REQUIRE(answer.status == Status::done);
    REQUIRE(answer.yes == expected);
    REQUIRE(hint.is_none() != expected);
    REQUIRE((!expected || holds(scene, hint)));
    REQUIRE((!held || (hint.a == before.a && hint.b == before.b)));
    ++(held ? kept : lost);
  });
  CHECK(kept > kRounds / 20);
  CHECK(lost > kRounds / 10);
}

TEST_CASE("small trees: a hint that is no pair of triangles is refused, as errors are") {
  Random random = test_random(3);
  const Scene scene(random);
  const Mesh& a = scene.a.view();
  const Mesh& b = scene.b.view();
  const auto refused = [&](Hint hint) {
    const Hint before = hint;
    const Answer answer = intersects(a, b, scene.pose, hint);
    return answer.status == Status::hint_invalid && answer.yes && hint.a == before.a &&
           hint.b == before.b;
  };
  CHECK(refused({a.triangle_count, 0}));
  CHECK(refused({0, b.triangle_count}));
  CHECK(refused({0, UINT16_MAX}));
  CHECK(refused({UINT16_MAX, 0}));

  const Pose wrong = Pose::translated(kMaxTranslation + 1, 0, 0);
  Hint hint = {0, 0};
  const Answer answer = intersects(a, b, wrong, hint);
  CHECK(answer.status == Status::translation_out_of_range);
  CHECK(answer.yes);
  CHECK(hint.is_none());
}
