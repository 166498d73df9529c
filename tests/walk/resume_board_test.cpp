// Queries cut into runs, and resumed in other objects, on trees that fit every board.
#include <initializer_list>

#include "digest/digest.hpp"
#include "support/most_work.hpp"
#include "support/rounds.hpp"
#include "support/small_scene.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

const int kRounds = rounds(40, 400);

using Position = QueryCursor<uint16_t>;

template <class Traversal>
using Scene = SmallScene<Traversal::Tree::kLayout>;

/// The position of a query that has a cursor.
template <class Traversal>
Position slot_of([[maybe_unused]] const Query<Traversal>& query) {
  if constexpr (Traversal::kStackless) {
    return query.cursor();
  } else {
    return {};
  }
}

/// Whether a query made progress: it changed position, made visits, or has no cursor.
template <class Traversal>
bool got_on(const Query<Traversal>& query, const QueryStats& before, const Position& was) {
  const Position is = slot_of(query);
  return !Traversal::kStackless || query.stats().visits != before.visits || is.a != was.a ||
         is.b != was.b || is.untested != was.untested || is.state != was.state;
}

void add(digest::Hash& hash, const Pair& pair) {
  hash.add(pair.a | static_cast<uint32_t>(pair.b) << 16);
}

/// A hash of the pairs in their order, from runs of `work` into an array of `capacity`, at most 4.
template <class Traversal>
uint64_t cut(const SmallScene<Traversal::Tree::kLayout>& scene, uint32_t work, uint32_t capacity,
             QueryStats& counts) {
  SmallQuery<Traversal> any(scene);
  digest::Hash report;
  Status status = Status::suspended;
  while (status != Status::done) {
    Pair found[4];
    const QueryStats before = any.query.stats();
    const Position was = slot_of(any.query);
    const RunResult step = any.query.run(work, found, capacity);
    for (uint32_t i = 0; i < step.count; ++i) {
      add(report, found[i]);
    }
    status = step.status;
    REQUIRE((status == Status::done || status == Status::suspended || status == Status::full));
    REQUIRE((status != Status::full || step.count == capacity));
    const uint32_t visits = any.query.stats().visits - before.visits;
    REQUIRE((work == kNoLimit ? step.work == 0 : step.work <= work && visits <= step.work));
    // A run neither stops before its work is done nor makes no progress.
    REQUIRE((status != Status::suspended || step.work == work));
    REQUIRE((status != Status::suspended || got_on(any.query, before, was)));
  }
  counts = any.query.stats();
  return report.value();
}

}  // namespace

TEST_CASE("small trees: however a query is cut into runs, it gives the same pairs") {
  for_each_order<uint16_t>([](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    for_rounds(kRounds, [&](Random& random, int) {
      const Scene<Traversal> scene(random);
      QueryStats counts{};
      const uint64_t whole = cut<Traversal>(scene, kNoLimit, 4, counts);
      for (const uint32_t work : {1u, 2u, 7u, 31u, 33u, 100u, 500u}) {
        for (const uint32_t capacity : {1u, 3u}) {
          CAPTURE(work, capacity);
          QueryStats others{};
          REQUIRE(cut<Traversal>(scene, work, capacity, others) == whole);
          REQUIRE(same(counts, others));
        }
      }
    });
  });
}

TEST_CASE("small trees: a query resumed in a new object after any run goes on") {
  for_each_stackless_order<uint16_t>([](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    for_rounds(kRounds, 1, [&](Random& random, int) {
      const Scene<Traversal> scene(random);
      QueryStats counts{};
      const uint64_t whole = cut<Traversal>(scene, kNoLimit, 4, counts);
      digest::Hash report;
      Position position{};
      uint32_t visits = 0;
      for (Status status = Status::suspended; status != Status::done;) {
        SmallQuery<Traversal> any(scene);
        status = any.query.resume(position);
        REQUIRE((status == Status::suspended || status == Status::done));
        Pair found[1];
        const RunResult step = any.query.run(1 + random.below(50), found);
        status = step.status;
        if (step.count != 0) {
          add(report, found[0]);
        }
        visits += any.query.stats().visits;
        position = any.query.cursor();
      }
      REQUIRE(report.value() == whole);
      REQUIRE(visits == counts.visits);
      SmallQuery<Traversal> ended(scene);
      REQUIRE(ended.query.resume(position) == Status::done);
    });
  });
}

TEST_CASE("small trees: any numbers for a position are refused or lead to an end") {
  for_each_stackless_order<uint16_t>([](auto named) {
    using Traversal = typename decltype(named)::Traversal;
    CAPTURE(named.name, static_cast<int>(Traversal::Tree::kLayout));
    int refused = 0;
    int taken = 0;
    for_rounds(100 * kRounds, 2, [&](Random& random, int) {
      const Scene<Traversal> scene(random);
      Position position{};
      position.a = static_cast<uint16_t>(random.below(random.below(2) == 0 ? 40 : 65536));
      position.b = static_cast<uint16_t>(random.below(random.below(2) == 0 ? 40 : 65536));
      position.untested = static_cast<uint16_t>(random.below(random.below(4) == 0 ? 65536 : 6));
      position.state = static_cast<QueryState>(random.below(6));
      SmallQuery<Traversal> any(scene);
      const Status before = any.query.status();
      if (any.query.resume(position) == Status::cursor_invalid) {
        REQUIRE(any.query.status() == before);
        ++refused;
        return;
      }
      ++taken;
      const uint32_t most = most_work_of_nodes(scene.a.view(), scene.b.view());
      REQUIRE(any.query.run(most, [](const Pair&) { return true; }).status == Status::done);
    });
    CHECK(refused > 20 * kRounds);
    CHECK(taken > kRounds);
  });
}
