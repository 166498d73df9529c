// Queries cut into runs, and resumed in other objects, on trees that fit every board.
#include <catch2/catch.hpp>
#include <initializer_list>

#include "small_tree/scene.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

#if defined(FLASHBVH_ON_BOARD)
constexpr int kRounds = 40;
#else
constexpr int kRounds = 400;
#endif

using Position = QueryPosition<uint16_t>;

template <class Traversal>
using Scene = SmallScene<Traversal::Tree::kLayout>;

/// In runs of `visits` into an array of `capacity`, at most 4.
template <class Traversal>
Report cut(const SmallScene<Traversal::Tree::kLayout>& scene, uint32_t visits, uint32_t capacity,
           Counts& counts) {
  SmallQuery<Traversal> any(scene);
  Report report;
  Status status = Status::suspended;
  while (status != Status::done) {
    Pair found[4];
    const uint32_t before = any.query.counts().visits;
    const Step step = any.query.run(visits, found, capacity);
    for (uint32_t i = 0; i < step.count; ++i) {
      report.add(found[i]);
    }
    status = step.status;
    REQUIRE((status == Status::done || status == Status::suspended || status == Status::full));
    REQUIRE((status != Status::full || step.count == capacity));
    REQUIRE(any.query.counts().visits - before <= visits);
  }
  counts = any.query.counts();
  return report;
}

}  // namespace

TEST_CASE("small trees: however a query is cut into runs, it gives the same pairs") {
  const uint64_t seed = test_seed();
  CAPTURE(seed);
  for_each_order<uint16_t>([seed](auto named) {
    using Order = typename decltype(named)::Order;
    CAPTURE(named.name, static_cast<int>(Order::Tree::kLayout));
    Random random(seed);
    for (int round = 0; round < kRounds; ++round) {
      const Scene<Order> scene(random);
      Counts counts{};
      const Report whole = cut<Order>(scene, kNoLimit, 4, counts);
      for (const uint32_t visits : {1u, 2u, 7u, 50u}) {
        for (const uint32_t capacity : {1u, 3u}) {
          CAPTURE(round, visits, capacity);
          Counts others{};
          const bool equal = cut<Order>(scene, visits, capacity, others) == whole;
          REQUIRE(equal);
          REQUIRE(same(counts, others));
        }
      }
    }
  });
}

TEST_CASE("small trees: a query resumed in a new object after any run goes on") {
  const uint64_t seed = test_seed();
  CAPTURE(seed);
  for_each_stackless_order<uint16_t>([seed](auto named) {
    using Order = typename decltype(named)::Order;
    CAPTURE(named.name, static_cast<int>(Order::Tree::kLayout));
    Random random(seed + 1);
    for (int round = 0; round < kRounds; ++round) {
      CAPTURE(round);
      const Scene<Order> scene(random);
      Counts counts{};
      const Report whole = cut<Order>(scene, kNoLimit, 4, counts);
      Report report;
      Position position;
      uint32_t visits = 0;
      for (Status status = Status::suspended; status != Status::done;) {
        SmallQuery<Order> any(scene);
        status = any.query.resume(position);
        REQUIRE((status == Status::suspended || status == Status::done));
        Pair found[1];
        const Step step = any.query.run(1 + random.below(3), found);
        status = step.status;
        if (step.count != 0) {
          report.add(found[0]);
        }
        visits += any.query.counts().visits;
        position = any.query.position();
      }
      const bool equal = report == whole;
      REQUIRE(equal);
      REQUIRE(visits == counts.visits);
    }
  });
}

TEST_CASE("small trees: any numbers for a position are refused or lead to an end") {
  const uint64_t seed = test_seed();
  CAPTURE(seed);
  for_each_stackless_order<uint16_t>([seed](auto named) {
    using Order = typename decltype(named)::Order;
    CAPTURE(named.name, static_cast<int>(Order::Tree::kLayout));
    Random random(seed + 2);
    int refused = 0;
    int taken = 0;
    for (int round = 0; round < 100 * kRounds; ++round) {
      CAPTURE(round);
      const Scene<Order> scene(random);
      Position position;
      position.a = static_cast<uint16_t>(random.below(random.below(2) == 0 ? 40 : 65536));
      position.b = static_cast<uint16_t>(random.below(random.below(2) == 0 ? 40 : 65536));
      position.untested = random.below(4) == 0 ? random.below(UINT32_MAX) : random.below(6);
      position.state = static_cast<Position::State>(random.below(6));
      SmallQuery<Order> any(scene);
      const Status before = any.query.status();
      if (any.query.resume(position) == Status::position_invalid) {
        REQUIRE(any.query.status() == before);
        ++refused;
        continue;
      }
      ++taken;
      const uint32_t most =
          static_cast<uint32_t>(scene.a.view().node_count) * scene.b.view().node_count + 1;
      REQUIRE(any.query.run(most, [](const Pair&) { return true; }) == Status::done);
    }
    CHECK(refused > 20 * kRounds);
    CHECK(taken > kRounds);
  });
}
