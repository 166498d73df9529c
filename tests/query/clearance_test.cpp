// Distances of meshes against brute force over all pairs of triangles.
#include "flashbvh/clearance.hpp"
#include "support/all_distances.hpp"
#include "support/any_mesh.hpp"
#include "support/check_clearance.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

bool is_of(const std::vector<Pairwise>& all, const Fraction& squared,
           const TrianglePair<std::uint16_t>& pair) {
  return std::any_of(all.begin(), all.end(), [&](const Pairwise& p) {
    return p.id_a == pair.a && p.id_b == pair.b && compare(p.squared, squared) == 0;
  });
}

void check_result(const std::vector<Pairwise>& all, const Clearance<std::uint16_t>& found) {
  const Fraction& least = least_of(all).squared;
  REQUIRE(found.status == Status::done);
  REQUIRE(is_of(all, least, found.triangles));
  REQUIRE(found.lower == lower_of(least));
  REQUIRE((found.upper == found.lower || found.upper == found.lower + 1));
  check_points(found);
}

/// Runs a query in any slices, and resumes each cursor in another query.
void check_slices(Random& random, const Mesh& a, const Mesh& b, const Pose& pose,
                  const Witness<std::uint16_t>& seed) {
  ClearanceQuery whole(a, b, pose, seed);
  REQUIRE(whole.run(kNoLimit).status == Status::done);
  const Clearance<std::uint16_t> truth = whole.result();
  const auto check = [&](const ClearanceQuery& query) {
    const Clearance<std::uint16_t> found = query.result();
    REQUIRE((found.lower == truth.lower && found.upper == truth.upper));
    REQUIRE((found.triangles.a == truth.triangles.a && found.triangles.b == truth.triangles.b));
    REQUIRE((same(found.point_a, truth.point_a) && same(found.point_b, truth.point_b)));
  };
  for (const std::uint32_t work : {1u, 2u, 7u, 31u, 33u, 100u}) {
    CAPTURE(work);
    ClearanceQuery cut(a, b, pose, seed);
    std::uint32_t upper = UINT32_MAX;
    for (std::uint32_t runs = 0; cut.run(work).status == Status::suspended; ++runs) {
      REQUIRE(runs < 1000000);
      const Clearance<std::uint16_t> known = cut.result();
      REQUIRE(known.lower == 0);
      REQUIRE(known.upper <= upper);
      REQUIRE(known.upper >= truth.lower);
      upper = known.upper;
    }
    check(cut);
    REQUIRE(same(cut.stats(), whole.stats()));
  }
  ClearanceQuery cut(a, b, pose, seed);
  std::uint32_t visits = 0;
  for (;;) {
    QueryCursor<std::uint16_t> position = cut.cursor();
    ClearanceQuery resumed(a, b, pose);
    const Status status = resumed.resume(position);
    REQUIRE(status == cut.status());
    if (status == Status::done) {
      check(resumed);
      break;
    }
    if (random.below(8) == 0) {
      REQUIRE(resumed.run(kNoLimit).status == Status::done);
      check(resumed);
      REQUIRE(visits + resumed.stats().visits == whole.stats().visits);
    }
    (void)cut.run(1 + random.below(40));
    visits = cut.stats().visits;
  }
}

void check_band(const std::vector<Pairwise>& all, const Mesh& a, const Mesh& b, const Pose& pose,
                std::uint32_t reach) {
  const Fraction limit = {{0, std::uint64_t{reach} * reach}, {0, 1 << 16}};
  const auto is_within = [&](const Pairwise& pair) { return compare(pair.squared, limit) <= 0; };
  check_pairs_within(all, is_within, a, b, pose, reach, {1, 50, kNoLimit});
}

}  // namespace

TEST_CASE("the distance of two meshes is that of their nearest triangles") {
  for_rounds(rounds(80, 250), [&](Random& random, int) {
    const std::int32_t spreads[] = {5, 60, 1000, 16000};
    const std::int32_t spread = random.one_of(spreads);
    const AnyMesh a = any_mesh(random, 20, spread, 1 + spread / 4);
    const AnyMesh b = any_mesh(random, 20, spread, 1 + spread / 4);
    const Pose pose = any_pose(random, spread > 6000 ? 23000 : spread * random.between(1, 4));
    const std::vector<Pairwise> all = all_distances(a, b, pose);
    check_result(all, distance(a, b, pose));
    // Every hint gives the exact distance, and a good hint is kept.
    for (int i = 0; i < 4; ++i) {
      const Pairwise& pair = i == 0 ? least_of(all) : random.one_of(all);
      check_result(all, distance(a, b, pose, {pair.of_a, pair.of_b}));
    }
    check_slices(random, a, b, pose, {});
    const Pairwise& any = random.one_of(all);
    check_slices(random, a, b, pose, {any.of_a, any.of_b});
    const std::uint32_t lower = lower_of(least_of(all).squared);
    for (const std::uint32_t reach : {lower, lower + 1, lower == 0 ? 0 : lower - 1, 2 * lower,
                                      lower + 256 * static_cast<std::uint32_t>(spread)}) {
      if (reach <= kMaxDistance) {
        check_band(all, a, b, pose, reach);
      }
    }
    // Swapped arguments give equal points, if nothing is rotated.
    if (pose.is_translation()) {
      const Clearance<std::uint16_t> back = distance(b, a, pose.inverse());
      REQUIRE((back.lower == lower && back.upper == distance(a, b, pose).upper));
    }
  });
}

TEST_CASE("seeds and positions that are none are refused") {
  Random random = test_random();
  const AnyMesh a = any_mesh(random, random_mesh(random, 20, 100, 20));
  const AnyMesh b = any_mesh(random, random_mesh(random, 15, 100, 20));
  const Pose pose = Pose::translated(500, 0, 0);
  CHECK(distance(a, b, pose, Witness<std::uint16_t>{20, 0}).status == Status::hint_invalid);
  CHECK(distance(a, b, pose, Witness<std::uint16_t>{0, 15}).status == Status::hint_invalid);
  CHECK(distance(a, b, pose, Witness<std::uint16_t>{65535, 0}).status == Status::hint_invalid);
  CHECK(distance(a, b, pose, Witness<std::uint16_t>{19, 14}).status == Status::done);

  const Clearance<std::uint16_t> truth = distance(a, b, pose);
  std::uint32_t taken = 0;
  for (int round = 0; round < rounds(10000, 30000); ++round) {
    const auto index = [&] { return static_cast<std::uint16_t>(random.below(80)); };
    QueryCursor<std::uint16_t> position;
    position.a = index();
    position.b = index();
    position.untested = static_cast<std::uint16_t>(random.below(5));
    position.state = static_cast<State>(random.below(5));
    position.witness_a = index();
    position.witness_b = index();
    position.has_witness = static_cast<std::uint8_t>(random.below(3));
    ClearanceQuery query(a, b, pose);
    const Status status = query.resume(position);
    if (status == Status::cursor_invalid) {
      REQUIRE(query.run(kNoLimit).status == Status::done);  // as a new query
      REQUIRE(query.result().lower == truth.lower);
      continue;
    }
    ++taken;
    REQUIRE(query.run(kNoLimit).status == Status::done);
    REQUIRE(query.result().upper >= truth.upper);
  }
  CHECK(taken > 100);
}

TEST_CASE("a hint that is far is dropped, and the nearest pair never") {
  int dropped = 0;
  int kept = 0;
  for_rounds(rounds(200, 1000), [&](Random& random, int round) {
    const AnyMesh a = any_mesh(random, random_mesh(random, 12, 2000, 400));
    const AnyMesh b = any_mesh(random, random_mesh(random, 12, 2000, 400));
    const Pose pose = any_pose(random, 2000 + 2000 * (round % 3));
    const std::vector<Pairwise> all = all_distances(a, b, pose);
    const auto query = [&](const Pairwise& pair) {
      return ClearanceQuery(a, b, pose, Witness<std::uint16_t>{pair.of_a, pair.of_b});
    };
    REQUIRE(query(least_of(all)).result().upper != UINT32_MAX);
    ClearanceQuery far = query(random.one_of(all));
    if (far.result().upper != UINT32_MAX) {
      ++kept;
      return;
    }
    ++dropped;
    ClearanceQuery cold(a, b, pose);
    REQUIRE(far.run(kNoLimit).status == Status::done);
    REQUIRE(cold.run(kNoLimit).status == Status::done);
    REQUIRE(same(far.stats(), cold.stats()));
  });
  CAPTURE(dropped, kept);
  CHECK(dropped > 20);
  CHECK(kept > 20);
}
