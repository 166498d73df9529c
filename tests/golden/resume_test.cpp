// A walk resumes from any cursor that resume() accepts, and ends: tests all cursors.
#include <catch2/catch.hpp>

#include "golden/golden.hpp"
#include "support/at_roots.hpp"
#include "support/compiled_queries.hpp"
#include "support/opened.hpp"
#include "support/walk.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// Makes walks as long as possible.
struct AlwaysOverlap {
  bool operator()(const PackedBox&, const PackedBox&) const { return true; }
};

template <class Traversal>
bool ends(const typename Traversal::Tree& a, const typename Traversal::Tree& b,
          typename Traversal::Cursor cursor, bool after) {
  const auto most = static_cast<std::uint32_t>(a.node_count) * b.node_count;
  const auto go_on = [](std::uint32_t, std::uint32_t, const Progress&) { return true; };
  // One more than the number of pairs: leaving the last pair is no visit.
  return walk_from<Traversal>(a, b, AlwaysOverlap(), cursor, go_on, most + 1, after).end ==
         State::done;
}

/// The number of tested cursors; 0 if a walk from one does not end.
template <class Traversal>
std::uint32_t try_positions(const typename Traversal::Tree& a, const typename Traversal::Tree& b) {
  using Cursor = typename Traversal::Cursor;
  using Index = typename Cursor::Index;
  std::uint32_t tried = 0;
  for (std::uint32_t i = 0; i < a.node_count; ++i) {
    for (std::uint32_t j = 0; j < b.node_count; ++j) {
      Cursor cursor;
      cursor.a = static_cast<Index>(i);
      cursor.b = static_cast<Index>(j);
      if (!Traversal::can_visit(a, b, cursor)) {
        continue;
      }
      ++tried;
      if (!ends<Traversal>(a, b, cursor, false) || !ends<Traversal>(a, b, cursor, true)) {
        CAPTURE(i, j);
        FAIL("a walk that does not end");
        return 0;
      }
    }
  }
  return tried;
}

/// Whether a walk's own cursors can be resumed; for `ranked`, whether no others can.
template <class Traversal>
bool accepts_positions_of_walk(const typename Traversal::Tree& a,
                               const typename Traversal::Tree& b) {
  using Cursor = typename Traversal::Cursor;
  constexpr bool kExact = std::is_same_v<Traversal, Ranked<typename Traversal::Tree>>;
  const auto go_on = [](std::uint32_t, std::uint32_t, const Progress&) { return true; };
  std::uint32_t walked = 0;
  Cursor cursor;
  bool accepted = true;
  do {
    ++walked;
    // A walk that does not begin at a leaf of A finds the first one by itself.
    const bool at_begin = walked == 1 && !Traversal::kStartsAtRoots;
    accepted = accepted && (at_begin || Traversal::can_visit(a, b, cursor));
  } while (walk_from<Traversal>(a, b, AlwaysOverlap(), cursor, go_on, 1).end != State::done);
  std::uint32_t possible = 0;
  for (std::uint32_t i = 0; kExact && i < a.node_count; ++i) {
    for (std::uint32_t j = 0; j < b.node_count; ++j) {
      using Index = typename Cursor::Index;
      cursor.a = static_cast<Index>(i);
      cursor.b = static_cast<Index>(j);
      possible += Traversal::can_visit(a, b, cursor) ? 1 : 0;
    }
  }
  return accepted && (!kExact || possible == walked);
}

template <class Tree>
std::uint32_t try_pairs() {
  std::uint32_t tried = 0;
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    for (std::size_t j = 0; j < kKeptImageCount; ++j) {
      Opened<Tree> of_a;
      Opened<Tree> of_b;
      const Tree& a = of_a.mesh;
      const Tree& b = of_b.mesh;
      if (!of_a.open(kKeptImages[i].bytes, kKeptImages[i].size) ||
          !of_b.open(kKeptImages[j].bytes, kKeptImages[j].size) ||
          a.node_count * b.node_count > 6000) {
        continue;
      }
      CAPTURE(kKeptImages[i].name, kKeptImages[j].name);
      for_each_stackless_order<typename Tree::Index>([&](auto named) {
        using Traversal = typename decltype(named)::Traversal;
        if constexpr (Traversal::Tree::kLayout == Tree::kLayout) {
          tried += try_positions<Traversal>(a, b);
          REQUIRE(accepts_positions_of_walk<Traversal>(a, b));
        }
      });
    }
  }
  return tried;
}

}  // namespace

TEMPLATE_TEST_CASE("a walk ends from every position that may be resumed, within all pairs of nodes",
                   "", PreMeshWithLevels, MeshWithLevels, PreMeshWithLevels32, MeshWithLevels32) {
  CHECK(try_pairs<TestType>() > 100);
}
