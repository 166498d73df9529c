// The walk supports other predicates. Here: pairs of triangles with boxes within a distance, by a
// box test and a triangle test of a few lines; traversals, walk and query are the library's.
#include "bake/baked_tree.hpp"
#include "flashbvh/query.hpp"
#include "reference/stackless.hpp"
#include "support/queries.hpp"
#include "support/record.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"
#include "support/transformed_vertex.hpp"

using namespace flashbvh::detail;

namespace {

/// The largest gap between the boxes of two triangles along an axis, in cells; 0 if there is none.
std::int32_t box_gap(const Triangle& a, const Triangle& b) {
  std::int32_t gap = 0;
  for (const auto axis : {&Point::x, &Point::y, &Point::z}) {
    const auto less = [axis](const Point& p, const Point& q) { return p.*axis < q.*axis; };
    const auto of_a = std::minmax_element(a.corner, a.corner + 3, less);
    const auto of_b = std::minmax_element(b.corner, b.corner + 3, less);
    gap = std::max({gap, (*of_a.first).*axis - (*of_b.second).*axis,
                    (*of_b.first).*axis - (*of_a.second).*axis});
  }
  return gap;
}

/// Passes boxes that are at most `distance` apart along each axis.
struct NearBound {
  Point offset;
  std::int32_t distance;

  bool operator()(const PackedBox& a, const PackedBox& b) const {
    const auto corners = [](const PackedBox& packed, const Point& t) {
      const Box box = unpack(packed);
      const Point lower = {box.lower.x + t.x, box.lower.y + t.y, box.lower.z + t.z};
      return Triangle{{lower, lower, {box.upper.x + t.x, box.upper.y + t.y, box.upper.z + t.z}}};
    };
    return box_gap(corners(a, kNoOffset), corners(b, offset)) <= distance;
  }
};

/// No coordinates of a triangle differ by more; its box on the other mesh's axes reaches no farther
/// beyond it than twice that.
constexpr std::int32_t kTriangleSize = 50;

/// The test under a rotation: the sums start with larger bounds, along B's axes by more than
/// sqrt(3) times the distance, and by what boxes on A's axes reach beyond the triangles.
class GrownBoxTest {
 public:
  GrownBoxTest(const RotatedTransform& transform, std::int32_t distance)
      : grown_(grown(transform, distance)), bound_(grown_) {}
  bool operator()(const PackedBox& a, const PackedBox& b) { return bound_(a, b); }

 private:
  static void grow(BoxTestStart& start, std::int32_t cells) {
    start.upper += cells * kSplitOne;
    start.lower += cells * kSplitOne;
  }
  static RotatedTransform grown(RotatedTransform transform, std::int32_t distance) {
    for (int i = 0; i < 3; ++i) {
      grow(transform.on_a[i], distance);
      grow(transform.on_b[i], 2 * distance + 2 * kTriangleSize);
    }
    return transform;
  }

  RotatedTransform grown_;
  RotatedBoxTest bound_;
};

struct WithinBoxDistance {
  static constexpr bool kIntersects = false;
  template <class Mesh>
  using Shapes = NoShapes<Mesh>;
  static constexpr std::uint32_t kBatch = 8;
  static constexpr std::uint32_t kPairWork = 32;
  static constexpr std::uint32_t kExpensiveWork = 0;
  static constexpr bool kKeepsShapes = true;
  static constexpr bool kDisjointRootsEnd = false;
  std::int32_t distance = 0;

  template <class Mesh>
  Status error_of(const Transform&, const Mesh&, const Mesh&) const {
    return Status::done;
  }
  NearBound translated(const TranslatedTransform& transform) const {
    return {transform.offset, distance};
  }
  GrownBoxTest rotated(const RotatedTransform& transform) const { return {transform, distance}; }
  bool test(const Triangle& a, const Triangle& b, std::uint32_t, std::uint32_t) const {
    return box_gap(a, b) <= distance;
  }
};

/// Pairs by their ids, in order.
template <class Mesh>
Pairs brute_force(const Mesh& a, const Mesh& b, const Pose& pose, std::int32_t distance) {
  const Transform transform(pose, a, b, /*may_stop=*/false);
  Pairs pairs;
  for_all_pairs(a, b, transform,
                [&](std::uint32_t i, std::uint32_t j, const Triangle& of_a, const Triangle& of_b) {
                  if (box_gap(of_a, of_b) <= distance) {
                    pairs.emplace_back(a.triangle_ids[i], b.triangle_ids[j]);
                  }
                });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class Traversal, class Baked>
void check(const Baked& baked_a, const Baked& baked_b, const Pose& pose, std::int32_t distance) {
  const auto a = baked_a.view();
  const auto b = baked_b.view();
  const Pairs truth = brute_force(a, b, pose, distance);
  for (const std::uint32_t work : {std::uint32_t{1}, std::uint32_t{7}, kNoLimit}) {
    Query<Traversal, WithinBoxDistance> query(a, b, pose, {}, {distance});
    Pairs pairs = run_to_end(query, work, 5);
    std::sort(pairs.begin(), pairs.end());
    REQUIRE(pairs == truth);
  }
}

}  // namespace

TEST_CASE("another question, boxes within a distance, is a bound and a test and no other walk") {
  std::uint32_t apart = 0;
  for_rounds(60, [&](Random& random, int round) {
    const auto mesh_a = random_mesh(random, 1 + random.below(30), 300, kTriangleSize / 2);
    const auto mesh_b = random_mesh(random, 1 + random.below(30), 300, kTriangleSize / 2);
    const auto a =
        bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh_a), mesh_a);
    const auto b =
        bake::lay_out<std::uint16_t, Layout::post_indexed>(any_tree(random, mesh_b), mesh_b);
    // Also if no sphere about one mesh reaches the other.
    const std::int32_t farthest = round % 3 == 0 ? 1500 : 500;
    const std::int32_t cells[3] = {random.between(-farthest, farthest),
                                   random.between(-farthest, farthest), 0};
    const Pose pose = round % 2 == 0
                          ? Pose::translated(cells[0], cells[1], cells[2])
                          : Pose::rigid(rotation_of(any_quaternion(random)).entry, cells);
    for (const std::int32_t distance : {0, 1, 40, 300, 1200}) {
      check<Ranked<Mesh>>(a, b, pose, distance);
      check<StacklessPost>(a, b, pose, distance);
      apart += brute_force(a.view(), b.view(), pose, distance).empty() ? 0 : 1;
    }
  });
  CHECK(apart > 60);
}
