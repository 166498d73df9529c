// The paper's setups of up to 796 faces: each shows what its table is about, and every traversal
// makes the same visits on every core.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

#include "flashbvh/paper/traversals.hpp"
#include "setup_counts.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using scene::Setup;

namespace {

/// `flashbvh bench --repetitions-scale 1e-9 --rounds 1` prints these.
struct Expected {
  const char* name;
  std::uint32_t volume, alternating, leaf, ranked;  ///< visits
  std::uint32_t ranked_by_default;                  ///< on the default tree
  std::uint32_t leaf_pairs, triangle_pairs;
};

const Expected kExpected[] = {
    {"Intersection test 1", 7639, 8111, 11858, 7461, 4275, 1031, 228},
    {"Intersection test 2", 11817, 13253, 19072, 11353, 6118, 1565, 338},
    {"Intersection test 3", 11559, 12481, 16192, 11071, 5495, 1501, 330},
    {"Separation test 1", 1, 1, 796, 1, 1, 0, 0},
    {"Separation test 2", 1, 1, 796, 1, 1, 0, 0},
    {"Separation test 3", 1, 1, 796, 1, 1, 0, 0},
    {"Close proximity test 1", 7117, 7887, 10946, 6963, 3705, 851, 0},
    {"Close proximity test 2", 14247, 15861, 18102, 13549, 7697, 1886, 0},
    {"Close proximity test 3", 3753, 3989, 5156, 3497, 1362, 297, 0},
    {"Small proximity test 1", 309, 349, 1054, 291, 165, 31, 0},
    {"Small proximity test 2", 811, 855, 2330, 813, 479, 50, 0},
    {"Small proximity test 3", 635, 671, 1738, 597, 281, 43, 0},
    {"Sub 0: 796 faces", 7669, 8449, 11844, 7411, 4020, 1002, 236},
    {"Different sizes", 93, 7407, 32498, 93, 19, 0, 0},
};

std::vector<Setup> small_setups(std::uint32_t table) {
  std::vector<Setup> chosen;
  for (const Setup& setup : scene::kSetups) {
    if (setup.table == table && setup.a.subdivisions == 0 && setup.b.subdivisions == 0) {
      chosen.push_back(setup);
    }
  }
  return chosen;
}

Counts by_volume(const Setup& setup) {
  return test::counts_of<VolumeStack<PreMesh>>(setup);
}

void check_counts(const Counts& counts, std::uint32_t visits, const Expected& expected) {
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

TEST_CASE("intersection setups: the geometry overlaps in a part of the many leaf overlaps") {
  for (const std::uint32_t table : {2u, 6u}) {
    for (const Setup& setup : small_setups(table)) {
      const Counts counts = by_volume(setup);
      CAPTURE(setup.name);
      CHECK(counts.leaf_pairs >= 500);
      CHECK(counts.triangle_pairs >= 100);
      CHECK(counts.triangle_pairs <= counts.leaf_pairs / 2);
    }
  }
}

TEST_CASE("separation setups: one visit tells") {
  for (const Setup& setup : small_setups(3)) {
    CHECK(by_volume(setup).visits == 1);
  }
}

TEST_CASE("close proximity setups: hundreds of leaf overlaps, none of geometry") {
  for (const Setup& setup : small_setups(4)) {
    const Counts counts = by_volume(setup);
    CAPTURE(setup.name);
    CHECK(counts.leaf_pairs >= 200);
    CHECK(counts.triangle_pairs == 0);
  }
}

TEST_CASE("small proximity setups: a few leaf overlaps, none of geometry") {
  for (const Setup& setup : small_setups(5)) {
    const Counts counts = by_volume(setup);
    CAPTURE(setup.name);
    CHECK(counts.visits <= 1000);
    CHECK(counts.leaf_pairs >= 1);
    CHECK(counts.leaf_pairs <= 100);
    CHECK(counts.triangle_pairs == 0);
  }
}

TEST_CASE(
    "different sizes: the alternating rule needs over twenty times the volume rule's visits") {
  const Setup setup = small_setups(7).at(0);
  const Counts counts = by_volume(setup);
  CHECK(counts.overlaps > 0);
  CHECK(counts.triangle_pairs == 0);
  CHECK(test::counts_of<Stackless>(setup).visits >= 20 * counts.visits);
}

TEST_CASE("every traversal makes the same visits and finds the same overlaps on every core") {
  for (const Setup& setup : scene::kSetups) {
    if (setup.a.subdivisions + setup.b.subdivisions != 0) {
      continue;
    }
    CAPTURE(setup.name);
    const auto* const expected =
        std::find_if(std::begin(kExpected), std::end(kExpected),
                     [&](const Expected& e) { return std::strcmp(e.name, setup.name) == 0; });
    REQUIRE(expected != std::end(kExpected));
    check_counts(by_volume(setup), expected->volume, *expected);
    check_counts(test::counts_of<AlternatingStack<LevelledPreMesh>>(setup), expected->alternating,
                 *expected);
    check_counts(test::counts_of<Stackless>(setup), expected->alternating, *expected);
    check_counts(test::counts_of<StacklessPost>(setup), expected->alternating, *expected);
    check_counts(test::counts_of<Leaf<PreMesh>>(setup), expected->leaf, *expected);
    check_counts(test::counts_of<Ranked<PostMesh>>(setup), expected->ranked, *expected);
    check_counts(test::counts_of<RankedStack<PostMesh>>(setup), expected->ranked, *expected);
    check_counts(test::counts_of<Ranked<PostMesh>>(setup, test::Built::by_default),
                 expected->ranked_by_default, *expected);
  }
}
