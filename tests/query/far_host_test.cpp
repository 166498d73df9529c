// Distances of meshes far apart, against exact rationals over all pairs of triangles.
#include "flashbvh/clearance.hpp"
#include "support/any_mesh.hpp"
#include "support/check_clearance.hpp"
#include "support/oracles/rational.hpp"
#include "support/test.hpp"
#include "support/transformed_vertex.hpp"

namespace {

constexpr std::int32_t kNear = 48000;
constexpr std::int32_t kFar = 1 << 20;

struct TruePair {
  std::uint32_t id_a;
  std::uint32_t id_b;
  std::uint16_t of_a;
  std::uint16_t of_b;
  mpq_class squared;
};

/// The distances of all pairs of triangles; the definition of a pose places B's vertices.
std::vector<TruePair> true_distances(const Mesh& a, const Mesh& b, const Pose& pose) {
  const Pose here = Pose::translated(0, 0, 0);
  std::vector<TruePair> all;
  for (std::uint32_t j = 0; j < b.triangle_count; ++j) {
    const Triangle of_b = transformed(b, j, pose);
    for (std::uint32_t i = 0; i < a.triangle_count; ++i) {
      all.push_back({a.triangle_ids[i], b.triangle_ids[j], static_cast<std::uint16_t>(i),
                     static_cast<std::uint16_t>(j),
                     Differences(transformed(a, i, here), of_b).squared_distance()});
    }
  }
  return all;
}

const mpq_class& least_of(const std::vector<TruePair>& all) {
  return std::min_element(
             all.begin(), all.end(),
             [](const TruePair& p, const TruePair& q) { return p.squared < q.squared; })
      ->squared;
}

/// 256 times the square root, rounded down; `exact`: whether this is exact.
std::uint32_t fine_root(const mpq_class& squared, bool& exact) {
  const mpq_class fine = squared * 65536;
  const mpz_class root = sqrt(mpz_class(fine.get_num() / fine.get_den()));
  exact = fine == root * root;
  return static_cast<std::uint32_t>(root.get_ui());
}

void check_distance(const std::vector<TruePair>& all, const Clearance<std::uint16_t>& found) {
  const mpq_class& least = least_of(all);
  bool exact = false;
  REQUIRE(found.status == Status::done);
  REQUIRE(found.in_range);
  REQUIRE(found.lower == fine_root(least, exact));
  REQUIRE(found.upper == found.lower + (exact ? 0 : 1));
  const auto same = [&](const TruePair& pair) {
    return pair.of_a == found.witness.a && pair.of_b == found.witness.b &&
           pair.id_a == found.triangles.a && pair.id_b == found.triangles.b &&
           pair.squared == least;
  };
  REQUIRE(std::any_of(all.begin(), all.end(), same));
  check_points(found);
}

void check_band(Random& random, const std::vector<TruePair>& all, const Mesh& a, const Mesh& b,
                const Pose& pose, std::uint32_t reach) {
  const mpq_class limit(mpz_class(reach) * reach, 65536);
  const auto is_within = [&](const TruePair& pair) { return pair.squared <= limit; };
  check_pairs_within(all, is_within, a, b, pose, reach, {1 + random.below(60), kNoLimit});
}

std::int32_t any_offset(Random& random) {
  constexpr std::int32_t at[] = {1 << 15, 40000,   kNear,          1 << 16,
                                 1 << 17, 1 << 18, (1 << 19) + 77, kFar - 1};
  const std::int32_t near = random.one_of(at);
  const std::int32_t offset = std::min(near + random.between(-1, 1), kFar - 1);
  return random.below(2) == 0 ? offset : -offset;
}

/// A pose far along at least one axis, or on either side of the far limit.
Pose any_far_pose(Random& random) {
  std::int32_t cells[3];
  for (std::int32_t& along : cells) {
    along = random.below(2) == 0 ? any_offset(random) : random.between(-kFar + 1, kFar - 1);
    along = random.below(3) == 0 ? along >> random.below(18) : along;
  }
  cells[random.below(3)] = any_offset(random);
  if (random.below(2) == 0) {
    return Pose::translated(cells[0], cells[1], cells[2]);
  }
  const auto quaternion = any_quaternion(random);
  // Half a cell less is still in range.
  std::int16_t fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    fraction[axis] = static_cast<std::int16_t>(cells[axis] > 0 ? -random.between(0, 32768)
                                                               : random.between(0, 32767));
  }
  return Pose::rigid(rotation_of(quaternion).entry, cells, fraction);
}

AnyMesh any_small_mesh(Random& random) {
  const std::int32_t spreads[] = {5, 60, 1000, 15000};
  const std::int32_t spread = random.one_of(spreads);
  bake::LatticeMesh mesh = random_mesh(random, 1 + random.below(9), spread, 1 + spread / 12);
  return any_mesh(random, mesh);
}

AnyMesh any_large_mesh(Random& random) {
  return any_mesh(random, random_mesh(random, 12, 15000, 1300));
}

/// A pose just beyond the far limit along one axis.
Pose any_pose_just_far(Random& random) {
  std::int32_t cells[3];
  for (std::int32_t& along : cells) {
    along = random.between(-2000, 2000);
  }
  const std::int32_t sign = random.below(2) == 0 ? 1 : -1;
  const std::int32_t far = kNear + random.between(0, 3000);
  cells[random.below(3)] = sign * far;
  return random.below(2) == 0 ? Pose::translated(cells[0], cells[1], cells[2])
                              : Pose::rigid(rotation_of(any_quaternion(random)).entry, cells);
}

}  // namespace

TEST_CASE("far apart the distance is that of exact rationals, from any hint, in any slices") {
  int far = 0;
  for_rounds(rounds(60, 800), [&](Random& random, int) {
    const AnyMesh a = any_small_mesh(random);
    const AnyMesh b = any_small_mesh(random);
    const Pose pose = any_far_pose(random);
    CAPTURE(pose.translation(0), pose.translation(1), pose.translation(2), pose.is_translation());
    const std::vector<TruePair> all = true_distances(a, b, pose);
    const Clearance<std::uint16_t> cold = distance(a, b, pose);
    if (cold.lower == 0) {
      return;  // clearance_test covers near scenes
    }
    check_distance(all, cold);
    far += detail::Transform(pose, a, b, false).is_near() ? 0 : 1;
    for (int i = 0; i < 3; ++i) {
      const TruePair& pair = random.one_of(all);
      check_distance(all, distance(a, b, pose, Witness<std::uint16_t>{pair.of_a, pair.of_b}));
    }
    ClearanceQuery cut(a, b, pose);
    std::uint32_t upper = UINT32_MAX;
    const std::uint32_t work = 1 + random.below(40);
    while (cut.run(work).status == Status::suspended) {
      const Clearance<std::uint16_t> known = cut.result();
      REQUIRE(known.lower == 0);
      REQUIRE((known.upper <= upper && known.upper >= cold.lower));
      upper = known.upper;
      ClearanceQuery resumed(a, b, pose);
      REQUIRE(resumed.resume(cut.cursor()) == Status::suspended);
      if (random.below(3) == 0) {
        REQUIRE(resumed.run(kNoLimit).status == Status::done);
        check_distance(all, resumed.result());
      }
    }
    check_distance(all, cut.result());
    // Swapped arguments, if nothing is rotated.
    if (pose.is_translation()) {
      const Clearance<std::uint16_t> back = distance(b, a, pose.inverse());
      REQUIRE((back.lower == cold.lower && back.upper == cold.upper));
      // A pose without rotation ignores fractions of a cell.
      constexpr std::int32_t one = kRotationOne;
      const Clearance<std::uint16_t> turned =
          distance(a, b,
                   Pose::rigid({{one, 0, 0}, {0, one, 0}, {0, 0, one}},
                               {pose.translation(0), pose.translation(1), pose.translation(2)},
                               {32767, -32768, 32767}));
      REQUIRE((turned.lower == cold.lower && turned.upper == cold.upper));
    }
    // With a tolerance.
    const auto tolerance = static_cast<std::uint16_t>(1 + random.below(2000));
    ClearanceQuery tolerant(a, b, pose, ClearanceQuery::Options{{}, tolerance});
    REQUIRE(tolerant.run(kNoLimit).status == Status::done);
    const Clearance<std::uint16_t> about = tolerant.result();
    const double longer = 1 + tolerance / 65536.0;
    REQUIRE((about.lower <= cold.lower && about.upper >= cold.upper));
    REQUIRE(about.upper <= cold.upper * longer + 1);
    REQUIRE((about.lower + 1) * longer >= about.upper - 1);
  });
  CHECK(far > 30);
}

TEST_CASE("far apart what is within a distance is what exact rationals say") {
  for_rounds(rounds(60, 800), [&](Random& random, int round) {
    const bool is_large = round % 3 == 0;
    const AnyMesh a = is_large ? any_large_mesh(random) : any_small_mesh(random);
    const AnyMesh b = is_large ? any_large_mesh(random) : any_small_mesh(random);
    const Pose pose = is_large ? any_pose_just_far(random) : any_far_pose(random);
    const std::vector<TruePair> all = true_distances(a, b, pose);
    bool exact = false;
    const std::uint32_t lower = fine_root(least_of(all), exact);
    const TruePair& any = random.one_of(all);
    for (const std::uint32_t reach :
         {lower - 1, lower, lower + 1, fine_root(any.squared, exact) + 1, lower + random.below(999),
          256u * 32767, 256u * 32767 + 1, 256u << 16, kMaxDistance}) {
      if (reach <= kMaxDistance) {
        check_band(random, all, a, b, pose, reach);
      }
    }
    REQUIRE(closer_than(a, b, pose, {kMaxDistance + 1}).status == Status::distance_out_of_range);
  });
}

TEST_CASE("where the range ends: in range to the last offset, bounds from there on") {
  Random random = test_random();
  const AnyMesh mesh = any_mesh(random, random_mesh(random, 6, 1000, 300));
  const std::int32_t one = kRotationOne;
  const std::int32_t turn[3][3] = {{0, -one, 0}, {one, 0, 0}, {0, 0, one}};
  for (const std::int32_t x : {kNear - 1, kNear, kNear + 1, kFar - 1, kFar, kFar + 1}) {
    for (int side = 0; side < 12; ++side) {
      std::int32_t cells[3] = {77, 5, -300};
      cells[side % 3] = side % 2 == 0 ? x : -x;
      const Pose pose =
          side < 6 ? Pose::translated(cells[0], cells[1], cells[2]) : Pose::rigid(turn, cells);
      const std::vector<TruePair> all = true_distances(mesh, mesh, pose);
      const Clearance<std::uint16_t> found = distance(mesh, mesh, pose);
      bool exact = false;
      const std::uint32_t lower = fine_root(least_of(all), exact);
      const Answer wide = closer_than(mesh, mesh, pose, {kMaxDistance});
      CHECK(found.in_range == (x < kFar));
      if (found.in_range) {
        check_distance(all, found);
        CHECK((wide.status == Status::done && wide.yes));
      } else {
        CHECK(found.lower <= lower);
        CHECK(found.upper >= lower + (exact ? 0 : 1));
        CHECK(found.upper - found.lower <= 256 * 8);
        CHECK((wide.status == Status::distance_out_of_range && wide.yes));
        const Answer near = closer_than(mesh, mesh, pose, {256u * (kFar - 10000)});
        CHECK((near.status == Status::done && !near.yes));
      }
    }
  }
}
