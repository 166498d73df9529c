// Distances of meshes, and pairs within a distance, against brute force over all pairs of
// triangles, near and far.
#include "flashbvh/detail/query/within_along.hpp"
#include "query/distance_scenes.hpp"

namespace {

constexpr double kExact = 1e-12;  // the error of doubles

/// Checks that the points are as far apart as reported, but for their rounding, and that the
/// direction leads from one to the other.
void check_points(const Found& found) {
  const FloatVector way = minus(vector_of<double>(found.point_b), vector_of<double>(found.point_a));
  const double apart = length_of(way);
  REQUIRE(apart <= found.upper + 1.8);
  REQUIRE(apart >= found.lower - 1.8);
  if (found.lower != 0) {
    const FloatVector direction = times(1.0 / kUnitOne, vector_of<double>(found.direction));
    REQUIRE(std::abs(length_of(direction) - 1) < 4e-9);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      REQUIRE(std::abs(direction[axis] * apart - way[axis]) <= 2);
    }
  } else {
    REQUIRE((found.upper != 0 || (found.direction.x | found.direction.y | found.direction.z) == 0));
  }
}

void check_result(const std::vector<Pairwise>& all, const Found& found) {
  const Fraction& least = least_of(all).squared;
  const std::uint32_t lower = lower_of(least);
  const Fraction whole = {{0, std::uint64_t{lower} * lower}, {0, 1 << 16}};
  REQUIRE(found.status == Status::done);
  REQUIRE(found.in_range);
  REQUIRE(found.lower == lower);
  REQUIRE(found.upper == lower + (compare(least, whole) == 0 ? 0 : 1));
  REQUIRE(std::any_of(all.begin(), all.end(), [&](const Pairwise& pair) {
    return pair.of_a == found.witness.a && pair.of_b == found.witness.b &&
           pair.id_a == found.triangles.a && pair.id_b == found.triangles.b &&
           compare(pair.squared, least) == 0;
  }));
  check_points(found);
}

/// Runs a query in slices, and resumes its cursors in another query.
void check_slices(Random& random, const Pairing& of, const Hint& hint) {
  ClearanceQuery whole(of.a, of.b, of.pose, hint);
  REQUIRE(whole.run(kNoLimit).status == Status::done);
  const Found truth = whole.result();
  const auto check = [&](const ClearanceQuery& query) {
    const Found found = query.result();
    REQUIRE((found.lower == truth.lower && found.upper == truth.upper));
    REQUIRE((found.triangles.a == truth.triangles.a && found.triangles.b == truth.triangles.b));
    REQUIRE((same(found.point_a, truth.point_a) && same(found.point_b, truth.point_b)));
  };
  for (const std::uint32_t work : {1u, 7u, 33u, 100u, 1 + random.below(40)}) {
    CAPTURE(work);
    ClearanceQuery cut(of.a, of.b, of.pose, hint);
    std::uint32_t upper = UINT32_MAX;
    while (cut.run(work).status == Status::suspended) {
      const Found known = cut.result();
      REQUIRE((known.lower == 0 && known.upper <= upper && known.upper >= truth.lower));
      upper = known.upper;
      ClearanceQuery resumed(of.a, of.b, of.pose);
      REQUIRE(resumed.resume(cut.cursor()) == Status::suspended);
      if (random.below(8) == 0) {
        REQUIRE(resumed.run(kNoLimit).status == Status::done);
        check(resumed);
        REQUIRE(cut.stats().visits + resumed.stats().visits == whole.stats().visits);
      }
    }
    check(cut);
    REQUIRE(same(cut.stats(), whole.stats()));
  }
}

/// The reported distance exceeds the true one, and `lower`, by at most the tolerance.
void check_tolerance(const Pairing& of, const Hint& hint, unsigned tolerance) {
  const auto allowed = static_cast<std::uint16_t>(tolerance);
  ClearanceQuery query(of.a, of.b, of.pose, {hint, allowed});
  REQUIRE(query.run(kNoLimit).status == Status::done);
  const Found found = query.result();
  const auto reported = std::find_if(of.all.begin(), of.all.end(), [&](const Pairwise& pair) {
    return pair.of_a == found.witness.a && pair.of_b == found.witness.b;
  });
  REQUIRE(reported != of.all.end());
  const double truth = root_of(least_of(of.all).squared);
  const double longer = (1 + tolerance / 65536.0) * (1 + kExact);
  const double distance = root_of(reported->squared);
  CAPTURE(tolerance, truth, distance, found.lower, found.upper);
  REQUIRE(distance <= truth * longer);
  REQUIRE(found.lower <= 256 * truth * (1 + kExact));
  REQUIRE((found.lower + 1) * longer >= 256 * distance);
  REQUIRE(found.upper >= 256 * distance * (1 - kExact));
  REQUIRE(found.upper < 256 * distance + 1);
}

/// The pairs within a distance, in runs of any work; also as a guard finds them.
void check_band(Random& random, const Pairing& of, std::uint32_t reach) {
  CAPTURE(reach);
  const Fraction limit = {{0, std::uint64_t{reach} * reach}, {0, 1 << 16}};
  Pairs truth;
  for (const Pairwise& pair : of.all) {
    if (compare(pair.squared, limit) <= 0) {
      truth.emplace_back(pair.id_a, pair.id_b);
    }
  }
  truth = sorted(truth);
  for (const std::uint32_t work : {1u, 1 + random.below(60), kNoLimit}) {
    WithinQuery query(of.a, of.b, of.pose, {}, within({reach}));
    REQUIRE(sorted(run_to_end(query, work, 5)) == truth);
    Query<Ranked<Mesh>, WithinAlong> along(of.a, of.b, of.pose, {}, WithinAlong(within({reach})));
    if (reach <= Within::kMostShort && along.status() == Status::suspended) {
      REQUIRE(sorted(run_to_end(along, work)) == truth);
    }
  }
  const Answer answer = closer_than(of.a, of.b, of.pose, {reach});
  REQUIRE(answer.status == Status::done);
  REQUIRE(answer.yes == !truth.empty());
}

void check_bands(Random& random, const Pairing& of) {
  const std::uint32_t lower = lower_of(least_of(of.all).squared);
  const std::uint32_t any = lower_of(random.one_of(of.all).squared) + 1;
  for (const std::uint32_t reach : {lower, lower + 1, lower - 1, 2 * lower, any, Within::kMostShort,
                                    Within::kMostShort + 1, kMaxDistance}) {
    if (reach <= kMaxDistance) {
      check_band(random, of, reach);
    }
  }
  REQUIRE(closer_than(of.a, of.b, of.pose, {kMaxDistance + 1}).status ==
          Status::distance_out_of_range);
}

}  // namespace

TEST_CASE("the distance of two meshes is that of their nearest triangles") {
  int far = 0;
  for_rounds(rounds(300, 2000), [&](Random& random, int round) {
    const Pairing of = Pairing::any(random, round % 3 == 0 ? 20 : 9, round % 2 == 0);
    far += Transform(of.pose, of.a, of.b, /*may_stop=*/false).is_near() ? 0 : 1;
    const Found cold = distance(of.a, of.b, of.pose);
    check_result(of.all, cold);
    // Every hint gives the exact distance, and a good hint is kept.
    const Pairwise& nearest = least_of(of.all);
    check_result(of.all, distance(of.a, of.b, of.pose, {nearest.of_a, nearest.of_b}));
    for (int i = 0; i < 3; ++i) {
      check_result(of.all, distance(of.a, of.b, of.pose, of.any_hint(random)));
    }
    check_slices(random, of, {});
    check_slices(random, of, of.any_hint(random));
    for (const unsigned tolerance : {0u, 1u, 655u, 32768u, 65535u}) {
      check_tolerance(of, {}, tolerance);
      check_tolerance(of, of.any_hint(random), tolerance);
    }
    check_bands(random, of);
    if (of.pose.is_translation()) {  // equal if swapped, and without fractions of a cell
      const Found back = distance(of.b, of.a, of.pose.inverse());
      REQUIRE((back.lower == cold.lower && back.upper == cold.upper));
      constexpr std::int32_t one = kRotationOne;
      const std::int32_t cells[3] = {of.pose.translation(0), of.pose.translation(1),
                                     of.pose.translation(2)};
      const Pose turned =
          Pose::rigid({{one, 0, 0}, {0, one, 0}, {0, 0, one}}, cells, {32767, -32768, 32767});
      REQUIRE(distance(of.a, of.b, turned).lower == cold.lower);
    }
  });
  CHECK(far > 20);
}

TEST_CASE("the distance of two leaves is that of their triangles, where bounds are tight") {
  for_rounds(rounds(3000, 30'000), 3, [&](Random& random, int round) {
    const Pairing of = round % 2 == 0 ? Pairing::of_leaves(random) : Pairing::of_fans(random);
    check_result(of.all, distance(of.a, of.b, of.pose));
    check_result(of.all, distance(of.a, of.b, of.pose, of.any_hint(random)));
    check_bands(random, of);
  });
}

TEST_CASE("beyond the range both bounds of a distance hold") {
  for_rounds(rounds(1500, 10'000), 1, [&](Random& random, int) {
    bake::LatticeMesh meshes[2];
    for (bake::LatticeMesh& mesh : meshes) {
      mesh = random_mesh(random, 1 + random.below(9), random.below(2) == 0 ? 1000 : 15000, 1000);
      for (std::int32_t& origin : mesh.origin) {
        origin = random.below(2) == 0 ? 0 : random.between(-500'000, 500'000);
      }
    }
    const AnyMesh a = any_mesh(random, meshes[0]);
    const AnyMesh b = any_mesh(random, meshes[1]);
    const std::int32_t offsets[] = {0,       77,     kFar - 1, kFar, kFar + 1, kFar + 60'000,
                                    1 << 22, 1 << 28};
    std::int32_t at[3];
    for (std::int32_t& along : at) {
      along = random.one_of(offsets) * (random.below(2) == 0 ? 1 : -1);
    }
    at[random.below(3)] = kFar + static_cast<std::int32_t>(random.below(20'000));
    // B's lattice lies there, turned about z by a multiple of 90 degrees.
    constexpr std::int32_t one = kRotationOne;
    const std::int32_t turns[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const auto& turn = random.one_of(turns);
    const std::int32_t rotation[3][3] = {
        {one * turn[0], -one * turn[1], 0}, {one * turn[1], one * turn[0], 0}, {0, 0, one}};
    const std::int32_t cells[3] = {
        at[0] + a.origin[0] - turn[0] * b.origin[0] + turn[1] * b.origin[1],
        at[1] + a.origin[1] - turn[1] * b.origin[0] - turn[0] * b.origin[1],
        at[2] + a.origin[2] - b.origin[2]};
    const Pose pose = Pose::rigid(rotation, cells);
    const auto floats = [](const Triangle& t) {
      return FloatTriangle{vector_of<double>(t.corner[0]), vector_of<double>(t.corner[1]),
                           vector_of<double>(t.corner[2])};
    };
    double truth = 1e18;
    for_all_pairs<Mesh>(a, a.triangle_count, b, b.triangle_count, pose,
                        [&](std::uint32_t, std::uint32_t, const Triangle& t, const Triangle& u) {
                          truth = std::min(truth,
                                           256 * std::sqrt(squared_distance(floats(t), floats(u))));
                        });
    ClearanceQuery cut(a, b, pose, random.below(2) == 0 ? Hint{} : Hint{0, 0});
    while (cut.run(1 + random.below(20)).status == Status::suspended) {
      const Found known = cut.result();
      REQUIRE((known.lower == 0 && known.witness.is_none()));
      REQUIRE((known.upper == UINT32_MAX || known.upper >= truth));
    }
    const Found found = cut.result();
    CAPTURE(truth, found.lower, found.upper, at[0], at[1], at[2]);
    REQUIRE(found.status == Status::done);
    REQUIRE_FALSE(found.in_range);
    REQUIRE(found.lower > 0);
    REQUIRE(found.lower <= truth * (1 + kExact));
    REQUIRE((found.upper == UINT32_MAX || found.upper >= truth * (1 - kExact)));
    double beyond = 2;  // the bounds differ by the part beyond the range, and some cells
    for (const std::int32_t along : at) {
      beyond += 256.0 * std::max(0, std::abs(along) - kFar + 4);
    }
    REQUIRE((found.upper == UINT32_MAX || found.upper - found.lower <= beyond));
    REQUIRE((found.witness.is_none() && found.triangles.a + found.triangles.b == 0));
    REQUIRE((same(found.point_a, FinePoint{}) && same(found.point_b, FinePoint{})));
    REQUIRE((found.direction.x | found.direction.y | found.direction.z) == 0);
    const Answer wide = closer_than(a, b, pose, {kMaxDistance});
    REQUIRE((wide.status == Status::done
                 ? !wide.yes
                 : wide.status == Status::distance_out_of_range && wide.yes));
    const Answer near = closer_than(a, b, pose, {256u * (kFar - 60'000)});
    REQUIRE((near.status == Status::done && !near.yes));
  });
}

TEST_CASE("hints and cursors that are none are refused") {
  Random random = test_random();
  const AnyMesh a = any_mesh(random, random_mesh(random, 20, 100, 20));
  const AnyMesh b = any_mesh(random, random_mesh(random, 15, 100, 20));
  const Pose pose = Pose::translated(500, 0, 0);
  for (const Hint& none : {Hint{20, 0}, Hint{0, 15}, Hint{65535, 0}}) {
    CHECK(distance(a, b, pose, none).status == Status::hint_invalid);
  }
  CHECK(distance(a, b, pose, Hint{19, 14}).status == Status::done);
  const Found truth = distance(a, b, pose);
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
    const bool is_taken = query.resume(position) != Status::cursor_invalid;
    taken += is_taken ? 1 : 0;
    REQUIRE(query.run(kNoLimit).status == Status::done);
    REQUIRE(query.result().upper >= truth.upper);
    REQUIRE((is_taken || query.result().lower == truth.lower));  // as a new query
  }
  CHECK(taken > 100);
}

TEST_CASE("a hint that is far is dropped, and the nearest pair never") {
  int dropped = 0;
  int kept = 0;
  for_rounds(rounds(200, 1000), 2, [&](Random& random, int round) {
    const AnyMesh a = any_mesh(random, random_mesh(random, 12, 2000, 400));
    const AnyMesh b = any_mesh(random, random_mesh(random, 12, 2000, 400));
    const Pose pose = any_pose(random, 2000 + 2000 * (round % 3));
    const std::vector<Pairwise> all = all_distances(a, b, pose);
    const auto query = [&](const Pairwise& pair) {
      return ClearanceQuery(a, b, pose, Hint{pair.of_a, pair.of_b});
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
