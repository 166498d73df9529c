// Distances of meshes, and pairs within a distance, against brute force over all pairs of
// triangles, near and far.
#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "flashbvh/detail/query/within_along.hpp"
#include "support/any_mesh.hpp"
#include "support/oracles/float_distance.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

using Found = Clearance<std::uint16_t>;
using Hint = Witness<std::uint16_t>;

/// From this offset on meshes are far, and from the next one on beyond the range.
constexpr std::int32_t kNear = 48000;
constexpr std::int32_t kFar = 1 << 20;
constexpr double kExact = 1e-12;  // the error of doubles

/// An offset next to the end of a range.
std::int32_t any_far_offset(Random& random) {
  constexpr std::int32_t at[] = {1 << 15, 40000,   kNear,          1 << 16,
                                 1 << 17, 1 << 18, (1 << 19) + 77, kFar - 1};
  const std::int32_t near = random.one_of(at);
  const std::int32_t offset = std::min(near + random.between(-1, 1), kFar - 1);
  return random.below(2) == 0 ? offset : -offset;
}

/// A pose far along at least one axis.
Pose any_far_pose(Random& random) {
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (std::int32_t& along : cells) {
    along = random.below(2) == 0 ? any_far_offset(random) : random.between(-kFar + 1, kFar - 1);
    along >>= random.below(3) == 0 ? random.below(18) : 0;
  }
  cells[random.below(3)] = any_far_offset(random);
  for (int axis = 0; axis < 3; ++axis) {  // half a cell less is still in range
    const std::int32_t part = random.between(0, 32767);
    fraction[axis] = static_cast<std::int16_t>(cells[axis] > 0 ? -part : part);
  }
  return random.below(2) == 0
             ? Pose::translated(cells[0], cells[1], cells[2])
             : Pose::rigid(rotation_of(any_quaternion(random)).entry, cells, fraction);
}

/// A pose that is turned, often as far from a rotation as a pose accepts.
Pose any_loose_pose(Random& random, std::int32_t far) {
  Rotation rotation = rotation_of(any_quaternion(random));
  const std::int32_t cells[3] = {random.between(-far, far), random.between(-far, far), 0};
  const Pose exact = Pose::rigid(rotation.entry, cells);
  for (auto& row : rotation.entry) {
    for (std::int32_t& entry : row) {
      entry += (random.below(8) == 0 ? -1 : 1) * (entry / 17000);
    }
  }
  const Pose loose = Pose::rigid(rotation.entry, cells);
  return loose.status() == Status::done && random.below(4) != 0 ? loose : exact;
}

bake::LatticeMesh one_triangle(const Vertex& p, const Vertex& q, const Vertex& r) {
  bake::LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

std::int32_t rounded(double cells) {
  return static_cast<std::int32_t>(std::lround(cells));
}

/// Triangles about a corner, in two leaves, nearly in the plane across `up` there.
AnyMesh fan(Random& random, const FloatVector& up, std::int32_t reach) {
  bake::LatticeMesh mesh;
  mesh.vertices = {{0, 0, 0}};
  for (std::uint32_t i = 1; i < 13; ++i) {
    FloatVector corner = {};
    for (double& along : corner) {
      along = reach * (random.between(-1000, 1000) / 1000.0);
    }
    const double height = random.between(-reach / 50 - 4, 1);
    corner = plus(corner, height - test::dot(corner, up), up);
    mesh.vertices.push_back(
        vertex_of({rounded(corner[0]), rounded(corner[1]), rounded(corner[2])}));
    if (i % 2 == 0) {
      mesh.triangles.push_back({0, i - 1, i});
    }
  }
  return AnyMesh(bake::build_median(mesh, 3), mesh);
}

/// A point above the middle of a triangle, `height` off its plane.
Vertex above(const Vertex& p, const Vertex& q, const Vertex& r, double height) {
  const FloatVector corner = vector_of<double>(p);
  const FloatVector u = minus(vector_of<double>(q), corner);
  const FloatVector v = minus(vector_of<double>(r), corner);
  const FloatVector n = cross(u, v);
  const FloatVector middle = plus(plus(corner, 1.0 / 3, u), 1.0 / 3, v);
  const FloatVector point = plus(middle, height / (length_of(n) + 1e-9), n);
  const auto at = [&](std::size_t axis) {
    return rounded(std::clamp<double>(point[axis], -kMaxCoordinate, kMaxCoordinate));
  };
  return vertex_of({at(0), at(1), at(2)});
}

struct Pairwise {
  Fraction squared;
  std::uint16_t of_a;  ///< slots
  std::uint16_t of_b;
  std::uint32_t id_a;
  std::uint32_t id_b;
};

/// The distances of all pairs of triangles, by slot in A, then in B.
std::vector<Pairwise> all_distances(const Mesh& a, const Mesh& b, const Pose& pose) {
  std::vector<Pairwise> all;
  for_all_pairs(
      a, a.triangle_count, b, b.triangle_count, pose,
      [&](std::uint32_t i, std::uint32_t j, const Triangle& of_a, const Triangle& of_b) {
        Fraction squared = kInfinite;
        Features features{};
        REQUIRE(is_nearer(of_a, of_b, squared, features));
        all.push_back({squared, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                       a.triangle_ids[i], b.triangle_ids[j]});
      });
  return all;
}

const Pairwise& least_of(const std::vector<Pairwise>& all) {
  return *std::min_element(all.begin(), all.end(), [](const Pairwise& p, const Pairwise& q) {
    return compare(p.squared, q.squared) < 0;
  });
}

/// In 1/256 cell, rounded down.
std::uint32_t lower_of(const Fraction& squared) {
  return static_cast<std::uint32_t>(
      square_root(quotient(shifted_up(squared.above, 16), squared.below)));
}

/// In cells, to the last bits of a double.
double root_of(const Fraction& squared) {
  const auto number = [](const Int128& u) {
    return std::ldexp(static_cast<double>(u.high), 64) + static_cast<double>(u.low);
  };
  return std::sqrt(number(squared.above) / number(squared.below));
}

/// Two meshes, and the distances of all pairs of their triangles.
struct Pairing {
  AnyMesh a;
  AnyMesh b;
  Pose pose;
  std::vector<Pairwise> all = all_distances(a, b, pose);

  /// Meshes of up to `most` triangles.
  static Pairing any(Random& random, std::uint32_t most, bool is_far) {
    const std::int32_t spreads[] = {5, 60, 1000, 15000};
    const std::int32_t spread = random.one_of(spreads);
    const std::int32_t reach = spread > 6000 ? 23000 : spread * random.between(1, 4);
    AnyMesh a = any_mesh(random, most, spread, 1 + spread / 4);
    AnyMesh b = any_mesh(random, most, spread, 1 + spread / 4);
    return {std::move(a), std::move(b), is_far ? any_far_pose(random) : any_pose(random, reach)};
  }
  /// A triangle, and a point above its middle or another triangle: bounds by leaves are tight.
  static Pairing of_leaves(Random& random) {
    const std::int32_t reach = 1 << (3 + random.below(11));
    const Vertex p = any_vertex(random, reach);
    const Vertex q = any_vertex(random, reach);
    const Vertex r = any_vertex(random, reach);
    const Vertex point = above(p, q, r, random.between(0, 16000));
    const Vertex u = any_vertex(random, 16000);
    const bool is_point = random.below(3) != 0;
    AnyMesh triangle = any_mesh(random, one_triangle(p, q, r));
    AnyMesh other = any_mesh(random, is_point ? one_triangle(point, point, point)
                                              : one_triangle(u, point, any_vertex(random, 16000)));
    const Pose pose = any_loose_pose(random, random.below(4) == 0 ? 20000 : 0);
    return random.below(2) == 0 ? Pairing{std::move(triangle), std::move(other), pose}
                                : Pairing{std::move(other), std::move(triangle), pose};
  }
  /// Fans that face each other: most pairs of leaves have ties alone.
  static Pairing of_fans(Random& random) {
    const Pose turn = any_pose(random, 0);
    const std::int32_t reach = 40 << random.below(9);
    FloatVector apart = {};
    for (double& along : apart) {
      along = random.between(-1000, 1000) + 0.5;
    }
    const FloatVector up = times(1 / length_of(apart), apart);
    FloatVector down = {};  // in B's lattice
    for (unsigned i = 0; i < 9; ++i) {
      down[i % 3] -= up[i / 3] * turn.rotation(int(i / 3), int(i % 3)) / kRotationOne;
    }
    AnyMesh a = fan(random, up, reach);
    AnyMesh b = fan(random, down, reach);
    const FloatVector to = times(random.between(reach / 40 + 2, reach), up);
    const Pose from = Pose::translated(-rounded(to[0]), -rounded(to[1]), -rounded(to[2]));
    return {std::move(a), std::move(b), Pose::relative(from, turn)};
  }
  Hint any_hint(Random& random) const {
    const Pairwise& pair = random.one_of(all);
    return {pair.of_a, pair.of_b};
  }
};

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
