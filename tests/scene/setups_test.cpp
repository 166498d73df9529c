// The paper's setups of up to 796 faces: every traversal makes the visits that `flashbvh bench`
// prints.
#include <string>

#include "bake/baked_tree.hpp"
#include "evaluate/count_query.hpp"
#include "evaluate/setups.hpp"
#include "flashbvh/traversal/traversals.hpp"
#include "support/test.hpp"

using scene::Setup;

namespace {

/// What `flashbvh bench` prints.
struct Expected {
  const char* name;
  std::uint32_t table;
  std::uint32_t volume, alternating, leaf, ranked;  ///< visits
  std::uint32_t ranked_by_default;                  ///< on the default tree
  std::uint32_t leaf_pairs, triangle_pairs;

  std::uint32_t visits_of(const std::string& algorithm) const {
    return algorithm == "volume-stack" ? volume
           : algorithm == "leaf"       ? leaf
           : algorithm == "ranked"     ? ranked
                                       : alternating;
  }
};

const Expected kExpected[] = {
    {"Intersection test 1", 2, 7639, 8111, 11858, 7461, 4275, 1031, 228},
    {"Intersection test 2", 2, 11817, 13253, 19072, 11353, 6118, 1565, 338},
    {"Intersection test 3", 2, 11559, 12481, 16192, 11071, 5495, 1501, 330},
    {"Separation test 1", 3, 1, 1, 796, 1, 1, 0, 0},
    {"Separation test 2", 3, 1, 1, 796, 1, 1, 0, 0},
    {"Separation test 3", 3, 1, 1, 796, 1, 1, 0, 0},
    {"Close proximity test 1", 4, 7117, 7887, 10946, 6963, 3705, 851, 0},
    {"Close proximity test 2", 4, 14247, 15861, 18102, 13549, 7697, 1886, 0},
    {"Close proximity test 3", 4, 3753, 3989, 5156, 3497, 1362, 297, 0},
    {"Small proximity test 1", 5, 309, 349, 1054, 291, 165, 31, 0},
    {"Small proximity test 2", 5, 811, 855, 2330, 813, 479, 50, 0},
    {"Small proximity test 3", 5, 635, 671, 1738, 597, 281, 43, 0},
    {"Sub 0: 796 faces", 6, 7669, 8449, 11844, 7411, 4020, 1002, 236},
    {"Different sizes", 7, 93, 7407, 32498, 93, 19, 0, 0},
};

bool is_small(const Setup& setup) {
  return setup.a.subdivisions == 0 && setup.b.subdivisions == 0;
}

template <class Index, Layout layout>
bake::BakedTree<Index, layout> bake_object(const scene::PaperObject& object, bool by_default) {
  const bake::LatticeMesh mesh = make_mesh(object);
  return bake::lay_out<Index, layout>(
      by_default ? bake::build_default(mesh, 1) : bake::build_median(mesh, 1), mesh);
}

/// Checks counts by boxes alone, like the paper's figures; on the paper's tree or the default one.
template <class Traversal>
void check_counts(const Setup& setup, std::uint32_t visits, const Expected& expected,
                  bool by_default = false) {
  using Index = typename Traversal::Tree::Index;
  constexpr Layout layout = Traversal::Tree::kLayout;
  const auto a = bake_object<Index, layout>(setup.a, by_default);
  const auto b = bake_object<Index, layout>(setup.b, by_default);
  const auto view_a = a.view();
  const auto view_b = b.view();
  scene::WalkStart<Traversal> start(view_a, view_b);
  const Point& t = setup.translation;
  const QueryStats counts =
      scene::count_query<Traversal>(view_a, view_b, Pose::translated(t.x, t.y, t.z), start);
  CHECK(counts.visits == visits);
  CHECK(counts.leaf_pairs == expected.leaf_pairs);
  CHECK(counts.triangle_pairs == expected.triangle_pairs);
}

}  // namespace

TEST_CASE("the setups are the paper's: so many of each table, the tables in order") {
  const std::uint32_t counts[] = {3, 3, 3, 3, 5, 1, 2};
  std::uint32_t table = scene::kFirstTable;
  std::uint32_t in_table = 0;
  for (const Setup& setup : scene::kSetups) {
    if (in_table == counts[table - scene::kFirstTable]) {
      ++table;
      in_table = 0;
    }
    CHECK(setup.table == table);
    ++in_table;
  }
  CHECK(table == scene::kLastTable);
}

TEST_CASE(
    "ranked makes at most 1.03 of the volume rule's visits, on the default tree 0.6 of stackless") {
  std::uint32_t ranked = 0, volume = 0, by_default = 0, stackless = 0;
  for (const Expected& expected : kExpected) {
    CAPTURE(expected.name);
    CHECK(100 * expected.ranked <= 103 * expected.volume);
    ranked += expected.ranked;
    volume += expected.volume;
    by_default += expected.ranked_by_default;
    stackless += expected.alternating;
  }
  CHECK(ranked <= volume);
  CHECK(100 * by_default <= 60 * stackless);
}

TEST_CASE("every traversal makes the same visits and finds the same overlaps on every core") {
  const Expected* expected = kExpected;
  for (const Setup& setup : scene::kSetups) {
    if (!is_small(setup)) {
      continue;
    }
    CAPTURE(setup.name);
    REQUIRE(expected != std::end(kExpected));
    REQUIRE(std::string(expected->name) == setup.name);
    REQUIRE(expected->table == setup.table);
    for_each_traversal([&](auto named) {
      CAPTURE(named.name);
      using Traversal =
          typename decltype(named)::template On<std::uint16_t, decltype(named)::kLayout>;
      check_counts<Traversal>(setup, expected->visits_of(named.name), *expected);
    });
    check_counts<Ranked<Mesh>>(setup, expected->ranked_by_default, *expected, true);
    ++expected;
  }
  CHECK(expected == std::end(kExpected));
}
