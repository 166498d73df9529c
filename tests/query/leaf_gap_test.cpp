// Triangles compared along a direction as they lie in flash, against their exact distances.
#include "flashbvh/detail/query/leaf_gap.hpp"

#include "flashbvh/clearance.hpp"
#include "support/all_distances.hpp"
#include "support/any_mesh.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

struct AnyScene {
  AnyMesh a;
  AnyMesh b;
  Pose pose;
};

AnyScene any_scene(Random& random, int round) {
  // Few cells and many, as far apart as they are large.
  const std::int32_t spread = round % 3 == 0 ? 5000 : 10 + 20 * (round % 7);
  const auto mesh = [&] {
    return any_mesh(random, random_mesh(random, 1 + random.below(14), spread, 1 + spread / 4));
  };
  return {mesh(), mesh(), any_pose(random, 3 * spread)};
}

Direction any_direction(Random& random) {
  return {static_cast<std::uint32_t>(random.next()) & 0x3FFFFFFF};
}

int component_of(const Direction& direction, int shift) {
  return static_cast<std::int32_t>(direction.packed << (22 - shift)) >> 22;
}

}  // namespace

TEST_CASE("no direction separates triangles that are within the limit") {
  long separated = 0;
  for_rounds(rounds(200, 2000), [&](Random& random, int round) {
    const AnyScene scene = any_scene(random, round);
    const Mesh a = scene.a.view<Mesh>();
    const Mesh b = scene.b.view<Mesh>();
    const std::vector<Pairwise> all = all_distances(a, b, scene.pose);
    Transform transform(scene.pose, a, b, /*may_stop=*/false);
    transform.bring_near();
    transform.prepare(b);
    for (int i = 0; i < 8; ++i) {
      // As far as some pair is, to the cell.
      const Pairwise& near = all[random.below(static_cast<std::uint32_t>(all.size()))];
      const auto cells = static_cast<std::int64_t>(length_of(near.squared));
      const std::int64_t limit = cells * cells;
      const ShortFraction within_limit = {static_cast<std::uint64_t>(limit), 1};
      const LeafGap gap(any_direction(random), transform, limit);
      for (const Pairwise& pair : all) {
        Triangle of_a;
        Triangle of_b;
        place_pair(a, pair.of_a, b, pair.of_b, transform, of_a, of_b);
        const bool is_near = is_within(of_a, of_b, within_limit);
        const bool by_gap = gap.separates(gap.end_of_a(a, pair.of_a), gap.start_of_b(b, pair.of_b));
        Direction any;
        CAPTURE(pair.of_a, pair.of_b, limit);
        REQUIRE(!(is_near && by_gap));
        REQUIRE(!(is_near && boxes_separate(of_a, of_b, limit, any)));
        REQUIRE(!(is_near && edges_separate(of_a, of_b, limit, any)));
        separated += by_gap ? 1 : 0;
      }
    }
  });
  CAPTURE(separated);
  CHECK(separated > 1000);
}

TEST_CASE("the direction of the boxes' gap has nine bits, however wide the gap is") {
  for_rounds(rounds(200, 2000), [&](Random& random, int round) {
    const auto any = [&] {
      const auto most = std::int32_t{1} << (round % 17);
      return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint32_t>(most) + 1)) -
             most;
    };
    const Point gap = {any(), any(), any()};
    const Triangle a = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    const Triangle b = {{gap, gap, gap}};
    Direction direction;
    const bool is_apart = boxes_separate(a, b, 0, direction);
    REQUIRE(is_apart == (gap.x != 0 || gap.y != 0 || gap.z != 0));
    if (is_apart) {
      const double length = std::hypot(gap.x, gap.y, gap.z);
      const int x = component_of(direction, 0);
      const int y = component_of(direction, 10);
      const int z = component_of(direction, 20);
      CAPTURE(gap.x, gap.y, gap.z, x, y, z);
      REQUIRE(std::max({std::abs(x), std::abs(y), std::abs(z)}) >= 255);
      const double cosine =
          (x * double{1} * gap.x + y * double{1} * gap.y + z * double{1} * gap.z) /
          (length * std::hypot(x, y, z));
      REQUIRE(cosine > 0.99997);
    }
  });
}

TEST_CASE("slivers that cross are separated along the normal of their edges") {
  constexpr std::int32_t length = 30000;
  for (std::int32_t apart = 600; apart < 9000; apart += 300) {
    // Wherever the other's ends are: B turns about their nearest points.
    for (std::int32_t along = -12000; along <= 12000; along += 3000) {
      const Triangle a = {{{-length, 0, 0}, {length, 0, 0}, {length, 1, -1}}};
      const Triangle b = {
          {{along, -length, apart}, {-along, length, apart}, {-along, length, apart + 1}}};
      Direction direction;
      const std::int64_t near = apart / 10 * 9;  // 12 bits turn the direction a little
      const std::int64_t limit = near * near;
      CAPTURE(apart, along);
      REQUIRE(edges_separate(a, b, limit, direction));
      REQUIRE(edges_separate(b, a, limit, direction));
      REQUIRE(!edges_separate(a, b, std::int64_t{apart} * apart, direction));
    }
  }
}

TEST_CASE("along a direction the same pairs are found as without, however the query is cut") {
  for_rounds(rounds(100, 1000), [&](Random& random, int round) {
    const AnyScene scene = any_scene(random, round);
    const Mesh a = scene.a.view<Mesh>();
    const Mesh b = scene.b.view<Mesh>();
    const std::vector<Pairwise> all = all_distances(a, b, scene.pose);
    const std::uint32_t distance =
        lower_of(all[random.below(static_cast<std::uint32_t>(all.size()))].squared) + 1;
    const auto found_by = [&](auto&& query, std::uint32_t work) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
      Status status = Status::suspended;
      while (status == Status::suspended) {
        status = query
                     .run(work,
                          [&](const TrianglePair<std::uint16_t>& pair) {
                            found.emplace_back(pair.a, pair.b);
                            return true;
                          })
                     .status;
      }
      REQUIRE(status == Status::done);
      return found;
    };
    const auto expected = found_by(WithinQuery(a, b, scene.pose, {}, within(distance)), UINT32_MAX);
    constexpr std::uint32_t budgets[] = {1, 7, 100, UINT32_MAX};
    for (const std::uint32_t work : budgets) {
      CAPTURE(distance, work);
      Query<Ranked<Mesh>, WithinAlong> query(a, b, scene.pose, {}, WithinAlong(within(distance)));
      REQUIRE(found_by(query, work) == expected);
    }
  });
}
