// Rays through meshes: against each triangle alone, against winding numbers, and at edges and
// corners of closed meshes.
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "support/any_mesh.hpp"
#include "support/boxes.hpp"
#include "support/points.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

namespace {

constexpr int kShare = share_on_board(20);

using Hit = RayHit<std::uint16_t>;

Point moved(const Point& p, const std::int32_t (&by)[3]) {
  return {p.x + by[0], p.y + by[1], p.z + by[2]};
}

bool same(const Hit& x, const Hit& y) {
  return x.triangle == y.triangle && x.slot == y.slot && x.side == y.side &&
         x.along.above == y.along.above && x.along.below == y.along.below;
}

/// The hits of each triangle alone, by the library's own test, which segment_hit_host_test.cpp
/// compares with rationals.
std::vector<Hit> all_hits(const Mesh& mesh, const Segment& segment) {
  detail::SegmentWalk<Mesh> walk(mesh, segment);
  std::vector<Hit> hits;
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    Hit hit;
    if (walk.get_hit(i, hit)) {
      hits.push_back(hit);
    }
  }
  return hits;
}

/// Tests all ray queries on one ray. Returns the number of hits in the nearest one's place.
std::uint32_t check_ray(Random& random, const Mesh& mesh, const Segment& segment) {
  const std::vector<Hit> hits = all_hits(mesh, segment);
  std::vector<Hit> found;
  const auto keep = [&](const Hit& hit) {
    found.push_back(hit);
    return true;
  };
  REQUIRE(for_each_hit(mesh, segment, keep) == Status::done);
  REQUIRE(found.size() == hits.size());
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const auto is_it = [&](const Hit& hit) { return same(hit, hits[i]); };
    REQUIRE(std::count_if(found.begin(), found.end(), is_it) == 1);
    REQUIRE(mesh.triangle_ids[hits[i].slot] == hits[i].triangle);
  }
  const auto any = any_hit(mesh, segment);
  REQUIRE((any.status == Status::done && any.yes == !hits.empty()));
  const auto nearest = nearest_hit(mesh, segment);
  REQUIRE((nearest.status == Status::done && nearest.yes == !hits.empty()));
  const auto seed = static_cast<std::uint16_t>(random.below(mesh.triangle_count));
  const auto seeded = nearest_hit(mesh, segment, seed);
  REQUIRE(seeded.yes == nearest.yes);
  if (hits.empty()) {
    return 0;
  }
  REQUIRE(same(any.hit, found.front()));
  REQUIRE(same(seeded.hit, nearest.hit));
  std::uint32_t in_one_place = 0;
  for (const Hit& hit : hits) {
    const int order = order_along(nearest.hit.along, hit.along);
    in_one_place += order == 0 ? 1 : 0;
    REQUIRE((order < 0 || (order == 0 && nearest.hit.triangle <= hit.triangle)));
  }
  std::uint32_t visited = 0;
  const auto stop = [&](const Hit&) {
    ++visited;
    return false;
  };
  REQUIRE(for_each_hit(mesh, segment, stop) == Status::full);
  REQUIRE(visited == 1);
  return in_one_place;
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

TEST_CASE("a ray hits what it hits of each triangle, of several in one place the least id") {
  std::uint32_t shared = 0;
  for_rounds(400 / kShare, [&](Random& random, int round) {
    bake::LatticeMesh lattice =
        round % 2 == 0 ? boxes(random) : random_mesh(random, 1 + random.below(40), 12, 9);
    for (std::int32_t& origin : lattice.origin) {
      origin = random.between(-(1 << 29), 1 << 29);
    }
    const AnyMesh mesh = any_mesh(random, lattice);
    for (int i = 0; i < 20; ++i) {
      const Point from = moved(any_point(random, 25), mesh.origin);
      const Point to = moved(any_point(random, i % 4 == 0 ? 100'000 : 25), mesh.origin);
      (void)check_ray(random, mesh, {from, to});
      // Through a corner, often of several triangles.
      const Vertex& v = mesh.vertices[random.below(mesh.vertex_count)];
      const Point corner = moved({v.x, v.y, v.z}, mesh.origin);
      const Point beyond = {2 * corner.x - from.x, 2 * corner.y - from.y, 2 * corner.z - from.z};
      shared += check_ray(random, mesh, {from, beyond}) > 1 ? 1 : 0;
    }
  });
  CHECK(shared > 3000 / kShare);
}

TEST_CASE("signed crossings are winding numbers' differences, through edges and corners too") {
  std::uint32_t changes = 0;
  for_rounds(200 / kShare, [&](Random& random, int) {
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
  CHECK(changes > 1000 / kShare);
}

TEST_CASE("no ray is lost at an edge or a corner of a closed mesh") {
  const bake::LatticeMesh lattice = torus(24, 16, 8000, 3000);
  const AnyMesh mesh(bake::build_default(lattice), lattice);
  for_rounds(rounds(3000, 30000) / kShare, [&](Random& random, int) {
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
  const AnyMesh mesh(bake::build_default(lattice), lattice);
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
  for_rounds(2000 / kShare, [&](Random& random, int round) {
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
