// The exact test as queries call it, on triangles that a walk brings together.
#include "flashbvh/detail/predicates/triangle.hpp"
#include "flashbvh/detail/query/leaf_triangles.hpp"
#include "support/rotations.hpp"
#include "support/test.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh::detail;

namespace {

/// Whether no edge is longer than 2^15 - 1 cells along an axis.
bool is_narrow(const Triangle& t) {
  for (const auto axis : kPointAxes) {
    for (int i = 0; i < 3; ++i) {
      if (std::abs(t.corner[i].*axis - t.corner[(i + 1) % 3].*axis) > 32767) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

TEST_CASE("narrow triangles intersect where triangles do") {
  std::uint32_t tested = 0;
  std::uint32_t intersect = 0;
  const auto tries = rounds(12000u, 60000u);
  for_rounds(tries, 8, [&](Random& random, std::uint32_t) {
    const TransformedPair pair = any_pair(random);
    const bool expected = triangles_intersect(pair.a, pair.b);
    REQUIRE(wide_triangles_intersect(pair.a, pair.b) == expected);
    if (is_narrow(pair.a) && is_narrow(pair.b)) {
      PlaneNormal normal;
      get_near_normal(pair.b, normal);
      REQUIRE(near_triangles_intersect(pair.a, pair.b, normal) == expected);
      ++tested;
      intersect += expected ? 1 : 0;
    }
  });
  CHECK(tested > tries / 3);
  CHECK(intersect > tries / 12);
}

TEST_CASE("a box and a triangle overlap where their bounds do") {
  std::uint32_t overlapping = 0;
  const auto tries = rounds(12000u, 60000u);
  for_rounds(tries, 9, [&](Random& random, std::uint32_t round) {
    const int size = round % 3 == 0 ? 3 : round % 3 == 1 ? 300 : kMaxCoordinate;
    const Vertex u = any_vertex(random, size);
    const Box box = box_around(u, any_vertex(random, size));
    Point shift = {0, 0, 0};
    for (const auto axis : kPointAxes) {
      shift.*axis = random.below(4) == 0 ? random.between(-80000, 80000) : 0;
    }
    const Triangle t = shifted(any_triangle(random, size), shift);
    bool expected = true;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = [&](int corner) { return t.corner[corner].*kPointAxes[axis]; };
      const auto [least, most] = std::minmax({at(0), at(1), at(2)});
      expected =
          expected && least <= box.upper.*kVertexAxes[axis] && most >= box.lower.*kVertexAxes[axis];
    }
    REQUIRE(box_overlaps(pack(box), t) == expected);
    overlapping += expected ? 1 : 0;
  });
  CHECK(overlapping > tries / 12);
  CHECK(overlapping < tries - tries / 12);
}

#if defined(FLASHBVH_LEAVES_AT_ONCE)

namespace {

/// Whether the CPU has AVX2; prints a note if not.
bool has_avx2() {
  const bool has = __builtin_cpu_supports("avx2") != 0;
  if (!has) {
    WARN("left out: no AVX2");
  }
  return has;
}

/// The lanes of a narrow triangle.
TriangleLanes lanes_of(const Triangle& t) {
  const Point& base = t.corner[0];
  Vertex corner[3];
  for (int i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Point& p = t.corner[i];
      corner[i].*kVertexAxes[axis] =
          static_cast<std::int16_t>(p.*kPointAxes[axis] - base.*kPointAxes[axis]);
    }
  }
  VertexTransform by;
  by.translate(base);
  TriangleLanes made;
  take_translated(by, {&corner[0], &corner[1], &corner[2]}, made);
  return made;
}

TransformedPair narrow_pair(Random& random) {
  for (;;) {
    const TransformedPair pair = any_pair(random);
    if (is_narrow(pair.a) && is_narrow(pair.b)) {
      return pair;
    }
  }
}

}  // namespace

TEST_CASE("triangles of two leaves tested at once intersect where triangles do") {
  if (!has_avx2()) {
    return;
  }
  std::uint32_t intersect = 0;
  const auto tries = rounds(12000u, 200000u);
  for_rounds(tries, 10, [&](Random& random, std::uint32_t) {
    const TransformedPair first = narrow_pair(random);
    const TransformedPair second = random.below(2) == 0 ? first : narrow_pair(random);
    const Triangle a[2] = {first.a, second.b};
    const Triangle b[2] = {first.b, second.a};
    const TriangleLanes lanes_a[2] = {lanes_of(a[0]), lanes_of(a[1])};
    const TriangleLanes lanes_b[2] = {lanes_of(b[0]), lanes_of(b[1])};
    for (std::uint32_t in_a = 1; in_a <= 2; ++in_a) {
      for (std::uint32_t in_b = 1; in_b <= 2; ++in_b) {
        std::uint32_t expected = 0;
        for (std::uint32_t j = 0; j < in_b; ++j) {
          for (std::uint32_t i = 0; i < in_a; ++i) {
            const bool answer = triangles_intersect(a[i], b[j]);
            expected |= (answer ? 1u : 0u) << (i + j * in_a);
            intersect += answer ? 1 : 0;
          }
        }
        REQUIRE(intersecting_pairs(lanes_a, in_a, lanes_b, in_b) == expected);
      }
    }
  });
  CHECK(intersect > tries);
}

TEST_CASE("corners of a rotated leaf are where the transform puts them") {
  if (!has_avx2()) {
    return;
  }
  const PackedBox all = pack({{-kMaxCoordinate, -kMaxCoordinate, -kMaxCoordinate},
                              {kMaxCoordinate, kMaxCoordinate, kMaxCoordinate}});
  for_rounds(rounds(3000, 100000), 11, [&](Random& random, int round) {
    const Pose pose = any_rigid_pose(random, round % 2 == 0 ? 40000 : kMaxTranslation);
    if (pose.is_translation()) {
      return;
    }
    const std::int32_t origin[3] = {0, 0, 0};
    RotatedTransform transform{};
    REQUIRE(transform.prepare(pose, origin, all, origin, all, /*may_stop=*/false));
    VertexTransform by;
    by.rotate(transform);
    Vertex corner[3];
    for (Vertex& v : corner) {
      for (const auto axis : kVertexAxes) {
        v.*axis = static_cast<std::int16_t>(random.below(4) == 0
                                                ? kMaxCoordinate * random.between(-1, 1)
                                                : random.between(-kMaxCoordinate, kMaxCoordinate));
      }
    }
    TriangleLanes made;
    take_rotated(by, {&corner[0], &corner[1], &corner[2]}, made);
    for (int i = 0; i < 3; ++i) {
      const Point expected = transform.transform(corner[i]);
      for (int axis = 0; axis < 3; ++axis) {
        REQUIRE(made.corner[i][axis] == expected.*kPointAxes[axis]);
      }
      REQUIRE(made.corner[i][3] == 0);
      REQUIRE(made.x[i] == expected.x);
      REQUIRE(made.y[i] == expected.y);
      REQUIRE(made.z[i] == expected.z);
    }
  });
}

#endif
