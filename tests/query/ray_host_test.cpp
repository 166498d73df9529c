// Rays through meshes: against exact rationals for each triangle, against winding numbers, and at
// edges and corners of closed meshes.
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "support/any_mesh.hpp"
#include "support/boxes.hpp"
#include "support/oracles/rational.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

using Hit = RayHit<std::uint16_t>;

Point moved(const Point& p, const std::int32_t (&by)[3]) {
  return {p.x + by[0], p.y + by[1], p.z + by[2]};
}

mpq_class rational(const SegmentShare& share) {
  mpq_class value(static_cast<long>(share.above), static_cast<long>(share.below));
  value.canonicalize();
  return value;
}

/// 1 if the triangle's corners run counter-clockwise, seen from the segment's start, -1 if
/// clockwise, 0 if the segment lies in the plane or there is none.
int side_met(const Segment& segment, const Triangle& t) {
  const auto at = [](const Point& p) { return vector_of<mpz_class>(p); };
  const test::Vector<mpz_class> o = at(t.corner[0]);
  const auto normal = cross(minus(at(t.corner[1]), o), minus(at(t.corner[2]), o));
  return -sgn(dot(normal, minus(at(segment.to), at(segment.from))));
}

struct TrueHit {
  std::uint16_t slot;
  std::uint16_t triangle;
  mpq_class along;
  int side;

  bool is(const Hit& hit) const {
    return hit.slot == slot && hit.triangle == triangle && hit.side == side &&
           hit.along.below > 0 && rational(hit.along) == along;
  }
};

/// The hits of all triangles.
std::vector<TrueHit> true_hits(const Mesh& mesh, const Segment& segment) {
  std::vector<TrueHit> hits;
  for (std::uint16_t i = 0; i < mesh.triangle_count; ++i) {
    const Triangle t = transformed(mesh, i, Pose::translated(0, 0, 0));
    const SegmentOracle oracle(segment, t);
    if (oracle.meets()) {
      hits.push_back({i, mesh.triangle_ids[i], oracle.first(), side_met(segment, t)});
    }
  }
  return hits;
}

/// The kinds of results so far, to check that all occur.
struct Seen {
  long hits = 0;
  long misses = 0;
  long in_plane = 0;
  long in_one_place = 0;  ///< several in the nearest one's place
};

/// Tests all ray queries on one ray.
void check_ray(Random& random, const Mesh& mesh, const Segment& segment, Seen& seen) {
  CAPTURE(segment.from.x, segment.from.y, segment.from.z, segment.to.x, segment.to.y, segment.to.z);
  const std::vector<TrueHit> hits = true_hits(mesh, segment);
  std::vector<Hit> found;
  const auto keep = [&](const Hit& hit) {
    found.push_back(hit);
    return true;
  };
  REQUIRE(for_each_hit(mesh, segment, keep) == Status::done);
  REQUIRE(found.size() == hits.size());
  for (const TrueHit& truth : hits) {
    REQUIRE(std::count_if(found.begin(), found.end(),
                          [&](const Hit& hit) { return truth.is(hit); }) == 1);
    seen.in_plane += truth.side == 0 ? 1 : 0;
  }
  const auto any = any_hit(mesh, segment);
  REQUIRE((any.status == Status::done && any.yes == !hits.empty()));
  const auto seed = static_cast<std::uint16_t>(random.below(mesh.triangle_count));
  const auto first =
      std::min_element(hits.begin(), hits.end(), [](const TrueHit& x, const TrueHit& y) {
        return x.along != y.along ? x.along < y.along : x.triangle < y.triangle;
      });
  for (const auto& nearest : {nearest_hit(mesh, segment), nearest_hit(mesh, segment, seed)}) {
    REQUIRE((nearest.status == Status::done && nearest.yes == !hits.empty()));
    REQUIRE((hits.empty() || first->is(nearest.hit)));
  }
  if (hits.empty()) {
    ++seen.misses;
    return;
  }
  ++seen.hits;
  REQUIRE(
      std::any_of(hits.begin(), hits.end(), [&](const TrueHit& hit) { return hit.is(any.hit); }));
  seen.in_one_place +=
      std::count_if(hits.begin(), hits.end(),
                    [&](const TrueHit& hit) { return hit.along == first->along; }) > 1
          ? 1
          : 0;
  std::uint32_t visited = 0;
  const auto stop = [&](const Hit&) {
    ++visited;
    return false;
  };
  REQUIRE(for_each_hit(mesh, segment, stop) == Status::full);
  REQUIRE(visited == 1);
}

Point point_between(const Point& u, const Point& v, std::int32_t share) {
  return {u.x + share * (v.x - u.x), u.y + share * (v.y - u.y), u.z + share * (v.z - u.z)};
}

/// Boxes, triangles on few cells, where everything coincides, or large and at the lattice's ends.
bake::LatticeMesh any_target(Random& random) {
  const std::uint32_t kind = random.below(4);
  const std::int32_t few = random.between(1, 3);
  bake::LatticeMesh mesh = kind == 0   ? boxes(random)
                           : kind == 1 ? random_mesh(random, 1 + random.below(40), 12, 9)
                           : kind == 2 ? random_mesh(random, 1 + random.below(6), 0, few)
                                       : random_mesh(random, 1 + random.below(3), 8000, 8000);
  for (Vertex& v : mesh.vertices) {
    if (kind == 3 && random.below(2) == 0) {
      const auto end = [&] { return random.below(2) == 0 ? kMaxCoordinate : -kMaxCoordinate; };
      const std::int32_t x = end();
      const std::int32_t y = end();
      v = vertex_of({x, y, end()});
    }
    v = kind > 1 && random.below(8) == 0 ? random.one_of(mesh.vertices) : v;
  }
  for (std::int32_t& origin : mesh.origin) {
    origin = random.between(-(1 << 29), 1 << 29);
  }
  return mesh;
}

bool is_hit_by_half(const RayAnswer<std::uint16_t>& answer) {
  return answer.status == Status::done && answer.yes &&
         2 * answer.hit.along.above <= answer.hit.along.below;
}

/// Whether a segment leaves a closed mesh with winding numbers 0 and 1 as often as it enters, but
/// for the side of its ends.
bool is_crossed_rightly(const Mesh& mesh, const Segment& segment) {
  const PointSide from = inside(mesh, segment.from).side;
  const PointSide to = inside(mesh, segment.to).side;
  const CrossingCount crossings = signed_crossings(mesh, segment);
  if (from == PointSide::on_surface || to == PointSide::on_surface) {
    return crossings.outwards >= -1 && crossings.outwards <= 1;
  }
  const auto winding = [](PointSide side) { return side == PointSide::inside ? 1 : 0; };
  return crossings.outwards == winding(from) - winding(to);
}

}  // namespace

TEST_CASE("a ray hits what exact rationals say, of several in one place the least id") {
  Seen seen;
  const auto rays = rounds(1200L, 20'000L);
  for_rounds(rays, [&](Random& random, long) {
    const AnyMesh mesh = any_mesh(random, any_target(random));
    const std::int32_t reaches[] = {3, 25, 25, 100'000, kMaxRayCoordinate - 2 * kMaxCoordinate};
    const std::int32_t reach = random.one_of(reaches);
    const Point from = moved(any_point(random, reach), mesh.origin);
    const Point to = moved(any_point(random, reach), mesh.origin);
    const std::uint32_t triangle = random.below(mesh.triangle_count);
    const Triangle t = transformed<Mesh>(mesh, triangle, Pose::translated(0, 0, 0));
    const Point u = random.one_of(t.corner);
    const Point v = random.one_of(t.corner);
    const Point w = random.one_of(t.corner);
    const Segment segments[] = {
        {from, to},
        {from, from},
        {from, point_between(from, u, 2)},                                     // through a corner
        {from, {u.x + v.x - from.x, u.y + v.y - from.y, u.z + v.z - from.z}},  // an edge's middle
        {from, u},
        {from, {u.x, u.y, u.z + 1}},
        {u, point_between(u, v, 2)},
        {point_between(u, v, -1), w},  // in the plane, from next to an edge
        {point_between(u, v, -1), point_between(v, w, 2)},
    };
    for (const Segment& segment : segments) {
      check_ray(random, mesh, segment, seen);
    }
  });
  CAPTURE(seen.hits, seen.misses, seen.in_plane, seen.in_one_place);
  CHECK((seen.hits > 2 * rays && seen.misses > rays / 2));
  CHECK((seen.in_plane > rays && seen.in_one_place > rays));
}

TEST_CASE("signed crossings are winding numbers' differences, through edges and corners too") {
  std::uint32_t changes = 0;
  for_rounds(200, [&](Random& random, int) {
    bake::LatticeMesh lattice = boxes(random);
    for (Vertex& v : lattice.vertices) {  // makes all middles lattice points
      v = vertex_of({2 * v.x, 2 * v.y, 2 * v.z});
    }
    const AnyMesh mesh = any_mesh(random, lattice);
    for (int i = 0; i < 50; ++i) {
      const Vertex& u = random.one_of(lattice.vertices);
      const Vertex& v = random.one_of(lattice.vertices);
      const Point middle = {(u.x + v.x) / 2, (u.y + v.y) / 2, (u.z + v.z) / 2};
      const Segment segment = {middle, any_point(random, 20)};
      const Winding from = winding_about(mesh, segment.from);
      const Winding to = winding_about(mesh, segment.to);
      const CrossingCount found = signed_crossings(mesh, segment);
      REQUIRE(found.status == Status::done);
      // For the whole segment, not only up to a hit.
      const auto any_of_it = any_hit(mesh, segment);
      REQUIRE((any_of_it.yes ? found.visits >= any_of_it.visits && found.visits <= mesh.node_count
                             : found.visits == any_of_it.visits));
      if (!from.on_surface && !to.on_surface) {
        REQUIRE(found.outwards == from.number - to.number);
        changes += from.number != to.number ? 1 : 0;
      }
      // Around a triangle of random points; a point on the surface counts equally each time.
      const Point third = any_point(random, 20);
      REQUIRE(found.outwards + signed_crossings(mesh, {segment.to, third}).outwards +
                  signed_crossings(mesh, {third, segment.from}).outwards ==
              0);
      REQUIRE(signed_crossings(mesh, {segment.to, segment.from}).outwards == -found.outwards);
    }
  });
  CHECK(changes > 1000);
}

TEST_CASE("no ray is lost at an edge or a corner of a closed mesh") {
  const bake::LatticeMesh lattice = torus(24, 16, 8000, 3000);
  const AnyMesh mesh(bake::build_default(lattice), lattice);
  for_rounds(rounds(3000, 30000), [&](Random& random, int) {
    // Exactly through a corner or the middle of an edge, where float ray casters lose rays.
    const auto& corner = mesh.triangles[random.below(mesh.triangle_count)].corner;
    const Vertex& u = mesh.vertices[corner[0]];
    const Vertex& v = mesh.vertices[corner[random.below(3)]];
    const auto reach = random.below(4) == 0 ? kMaxRayCoordinate - 2 * kMaxCoordinate : 20'000;
    const Point from = any_point(random, reach);
    const Segment segment = {from, {u.x + v.x - from.x, u.y + v.y - from.y, u.z + v.z - from.z}};
    REQUIRE(is_hit_by_half(nearest_hit(mesh, segment)));
    REQUIRE(is_hit_by_half(nearest_hit(mesh, {segment.to, segment.from})));
    REQUIRE(is_crossed_rightly(mesh, segment));
  });
}

TEST_CASE("what is behind the nearest hit, or behind the seed, is not visited") {
  Random random(20240607);  // counts of these rays, whatever the seed
  const bake::LatticeMesh lattice = torus(24, 16, 8000, 3000);
  const AnyMesh mesh(bake::build_default(lattice, 2), lattice);
  std::uint32_t all = 0;
  std::uint32_t nearest = 0;
  std::uint32_t seeded = 0;
  for (int i = 0; i < 200; ++i) {
    // Along the ring's middle: through both walls and the space in between.
    const Segment segment = {{-12000, random.between(-2000, 2000), random.between(-2000, 2000)},
                             {12000, random.between(-2000, 2000), random.between(-2000, 2000)}};
    const auto found = nearest_hit(mesh, segment);
    REQUIRE((found.yes && found.visits != 0));
    all += signed_crossings(mesh, segment).visits;
    nearest += found.visits;
    seeded += nearest_hit(mesh, segment, found.hit.slot).visits;
  }
  CAPTURE(all, nearest, seeded);
  CHECK(nearest * 10 < all * 9);
  CHECK(seeded * 10 < nearest * 9);
}

TEST_CASE("where a hit is, and how far off") {
  for_rounds(2000, [&](Random& random, int round) {
    const Point from = any_point(random, round % 2 == 0 ? 500 : kMaxRayCoordinate);
    const Point to = any_point(random, round % 3 == 0 ? 500 : kMaxRayCoordinate);
    const std::int64_t bits = random.below(1u << 30);
    const std::int64_t below = 1 + bits * (std::int64_t{1} << random.below(23));
    const std::int64_t above = below / (1 + random.below(9));
    const double share = static_cast<double>(above) / static_cast<double>(below);
    const FinePoint at = point_along({from, to}, {above, below});
    const auto is_near = [share](std::int64_t fine, std::int32_t u, std::int32_t v) {
      return std::fabs(static_cast<double>(fine) - 256 * (u + share * (v - u))) <= 1;
    };
    REQUIRE((is_near(at.x, from.x, to.x) && is_near(at.y, from.y, to.y) &&
             is_near(at.z, from.z, to.z)));
    const FloatVector way = minus(vector_of<double>(to), vector_of<double>(from));
    const double wanted = 256 * share * length_of(way);
    REQUIRE(std::fabs(distance_along({from, to}, {above, below}) - wanted) <= 3);
  });
  const Segment along_x = {{-100, 5, 7}, {100, 5, 7}};
  CHECK(point_along(along_x, {1, 2}).x == 0);
  CHECK(distance_along(along_x, {1, 2}) == 100 * 256);
  CHECK(distance_along(along_x, {0, 1}) == 0);
  CHECK(distance_along(along_x, {3, 3}) == 200 * 256);
}

TEST_CASE("shares of segments are distinguished by one part in 2^105") {
  constexpr std::int64_t most = std::int64_t{1} << 53;
  CHECK(order_along({most - 2, most - 1}, {most - 1, most}) < 0);
  CHECK(order_along({most - 1, most}, {most - 2, most - 1}) > 0);
  CHECK(order_along({most / 2, most}, {1, 2}) == 0);
  CHECK(order_along({0, 5}, {0, most}) == 0);
}

TEST_CASE("what no ray can be is refused, and may hit") {
  Random random = test_random();
  bake::LatticeMesh lattice = random_mesh(random, 5, 20, 20);
  lattice.origin = {1000, -(1 << 29), 1 << 29};
  AnyMesh mesh = any_mesh(random, lattice);
  const auto at = [&](std::int32_t x, std::int32_t y, std::int32_t z) -> Point {
    return {mesh.origin[0] + x, mesh.origin[1] + y, mesh.origin[2] + z};
  };
  const Point here = at(0, 0, 0);
  constexpr std::int32_t most = kMaxRayCoordinate;
  CHECK(nearest_hit(mesh, {here, at(most, -most, most)}).status == Status::done);
  const Point far[] = {at(most + 1, 0, 0),
                       at(0, -most - 1, 0),
                       at(0, 0, most + 1),
                       {INT32_MIN, INT32_MAX, INT32_MIN},
                       {INT32_MAX, INT32_MIN, INT32_MAX}};
  for (const Point& p : far) {
    const Segment segments[] = {{here, p}, {p, here}};
    for (const Segment& segment : segments) {
      CHECK(nearest_hit(mesh, segment).status == Status::ray_out_of_range);
      CHECK(nearest_hit(mesh, segment).yes);
      CHECK(any_hit(mesh, segment).status == Status::ray_out_of_range);
      CHECK(any_hit(mesh, segment).yes);
      CHECK(for_each_hit(mesh, segment, [](const Hit&) { return true; }) ==
            Status::ray_out_of_range);
      mesh.is_closed = true;
      CHECK(signed_crossings(mesh, segment).status == Status::ray_out_of_range);
      mesh.is_closed = false;
      CHECK(signed_crossings(mesh, segment).status == Status::not_closed);
      CHECK(signed_crossings(mesh, segment).visits == 0);
    }
  }
  const auto count = static_cast<std::uint16_t>(mesh.triangle_count);
  CHECK(nearest_hit(mesh, {here, here}, count).status == Status::hint_invalid);
  CHECK(nearest_hit(mesh, {here, here}, count).yes);
}
