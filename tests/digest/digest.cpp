// Prints one number for thousands of queries: every reported pair, in order, every count, and, with
// one traversal, each pair's contact. Exits with 0 if it is the one of every core and compiler.
#include "digest.hpp"

#include "flashbvh/clearance.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "small_mesh.hpp"
#include "support/at_roots.hpp"
#include "support/points.hpp"
#include "support/print.hpp"

#if defined(FLASHBVH_ON_BOARD)
#include "stack.hpp"
#endif

namespace digest {

using namespace flashbvh;
using namespace flashbvh::detail;
using flashbvh::test::any_point;
using flashbvh::test::print;
using flashbvh::test::Random;

namespace {

struct Result {
  uint32_t cases;    ///< (mesh pair, pose, rule)
  uint32_t pairs;    ///< of triangles that intersect, over all cases
  uint32_t refused;  ///< trees that check_tree() refuses: 0
};

constexpr uint32_t kMeshPairs = 32;
constexpr uint32_t kPoses = 16;
constexpr uint64_t kSeed = 0x666C617368627668u;

struct Side {
  SmallMesh mesh;
  SmallTree<Layout::pre_indexed> pre;
  SmallTree<Layout::post_indexed> post;
};

// Static, since the smallest core's stack is too small.
Side side_a;
Side side_b;
PairCursor<uint16_t> stack[2 * kMostTriangles];

/// Returns the number of trees that check_tree() refuses.
uint32_t make_trees(Side& side, Shape shape, uint32_t leaf_size) {
  const bool pre = side.pre.make(side.mesh, shape, leaf_size);
  const bool post = side.post.make(side.mesh, shape, leaf_size);
  return (pre ? 0u : 1u) + (post ? 0u : 1u);
}

uint32_t make_side(Random& random, const Scale& scale, Side& side) {
  make_mesh(random, scale, side.mesh);
  const auto shape = static_cast<Shape>(random.below(4));
  const uint32_t leaf_size = 1 + random.below(3);
  return make_trees(side, shape, leaf_size);
}

void add_point(const FinePoint& point, Hash& hash) {
  const int64_t coordinates[] = {point.x, point.y, point.z};
  for (const int64_t coordinate : coordinates) {
    hash.add(static_cast<uint32_t>(coordinate));
    hash.add(static_cast<uint32_t>(coordinate >> 32));
  }
}

void add_contact(const Contact& contact, Hash& hash) {
  hash.add(static_cast<uint32_t>(contact.kind));
  add_point(contact.ends[0], hash);
  add_point(contact.ends[1], hash);
}

void add_counts(const QueryStats& counts, Hash& hash) {
  hash.add(counts.visits);
  hash.add(counts.overlaps);
  hash.add(counts.leaf_pairs);
  hash.add(counts.triangle_pairs);
}

// Functions with large frames are not inlined: the smallest board's stack holds one at a time.

template <class Traversal, bool with_contacts = false>
[[gnu::noinline]] void add_query(const typename Traversal::Tree& a,
                                 const typename Traversal::Tree& b, const Pose& pose,
                                 uint32_t slice, Hash& hash, Result& result) {
  Query<Traversal> query(a, b, pose, test::at_roots<Traversal>(stack, 2 * kMostTriangles));
  const auto add_pair = [&](const TrianglePair<uint16_t>& pair) {
    hash.add(pair.a | static_cast<uint32_t>(pair.b) << 16);
    return !with_contacts;  // contacts are computed between runs: the smallest board's stack
  };
  Status status = Status::suspended;
  while (status == Status::suspended || status == Status::full) {
    if (status == Status::full) {
      add_contact(contact_of_last(query), hash);
    }
    status = query.run(slice, add_pair).status;
  }
  hash.add(static_cast<uint32_t>(status));
  add_counts(query.stats(), hash);
  ++result.cases;
  result.pairs += query.stats().triangle_pairs;
}

/// Moves a pose far along one axis: to about the limit from which distances place B far, or to the
/// end of their range and slightly beyond.
[[gnu::noinline]] Pose moved_far(Random& random, const Pose& pose) {
  const int32_t most = random.below(3) == 0 ? 50'000 : (1 << 20) + 5'000;
  const Point by = any_point(random, most);
  const int32_t far = random.between(46'000, most);
  const uint32_t axis = random.below(3);
  return Pose::composed(
      Pose::translated(axis == 0 ? far : by.x, axis == 1 ? -far : by.y, axis == 2 ? far : by.z),
      pose);
}

/// The distance, with the last nearest pair as hint, and the pairs within it and slightly more.
[[gnu::noinline]] void add_distance(const Mesh& a, const Mesh& b, const Pose& pose, uint32_t slice,
                                    Witness<uint16_t>& seed, Hash& hash) {
  uint32_t upper = 0;
  {
    ClearanceQuery query(a, b, pose, seed);
    while (query.run(slice).status == Status::suspended) {
    }
    add_counts(query.stats(), hash);
    const Clearance<uint16_t> found = query.result();
    hash.add(found.lower);
    hash.add(found.upper);
    hash.add(found.triangles.a | static_cast<uint32_t>(found.triangles.b) << 16);
    add_point(found.point_a, hash);
    add_point(found.point_b, hash);
    hash.add(static_cast<uint32_t>(found.direction.x));
    hash.add(static_cast<uint32_t>(found.direction.y));
    hash.add(static_cast<uint32_t>(found.direction.z));
    seed = found.witness;
    upper = found.upper;
  }
  WithinQuery query(a, b, pose, {},
                    within({upper < kMaxDistance - 500 ? upper + 500 : kMaxDistance}));
  while (query
             .run(slice,
                  [&](const TrianglePair<uint16_t>& pair) {
                    hash.add(pair.a | static_cast<uint32_t>(pair.b) << 16);
                    return true;
                  })
             .status == Status::suspended) {
  }
  add_counts(query.stats(), hash);
}

/// All hits of a ray, the nearest one, its crossings, and its start's side, for a mesh marked
/// closed. The mesh need not be closed for crossings.
[[gnu::noinline]] void add_ray(const Mesh& mesh, Random& random, int32_t reach, Hash& hash) {
  Mesh closed = mesh;
  closed.is_closed = true;
  const Segment segment = {any_point(random, reach), any_point(random, reach)};
  const auto add_hit = [&](const RayHit<uint16_t>& hit) {
    hash.add(hit.triangle | static_cast<uint32_t>(hit.side + 1) << 16);
    add_point(point_along(segment, hit.along), hash);
    hash.add(distance_along(segment, hit.along));
    return true;
  };
  hash.add(static_cast<uint32_t>(for_each_hit(closed, segment, add_hit)));
  const RayAnswer<uint16_t> nearest = nearest_hit(closed, segment);
  hash.add(nearest.visits);
  if (nearest.yes) {
    add_hit(nearest.hit);
  }
  hash.add(static_cast<uint32_t>(signed_crossings(closed, segment).outwards));
  const PointAnswer from = inside(closed, segment.from);
  hash.add(static_cast<uint32_t>(from.side));
  hash.add(from.visits);
}

/// Runs every traversal; the hash depends on their order.
void add_pose(const Pose& pose, uint32_t slice, Hash& hash, Result& result) {
  const PreMeshWithLevels& pre_a = side_a.pre.view();
  const PreMeshWithLevels& pre_b = side_b.pre.view();
  const MeshWithLevels& post_a = side_a.post.view();
  const MeshWithLevels& post_b = side_b.post.view();
  add_query<Ranked<Mesh>, true>(post_a, post_b, pose, slice, hash, result);
  add_query<test::RankedStack<Mesh>>(post_a, post_b, pose, slice, hash, result);
  add_query<VolumeStack>(pre_a, pre_b, pose, slice, hash, result);
  add_query<AlternatingStackPost>(post_a, post_b, pose, slice, hash, result);
  add_query<Stackless>(pre_a, pre_b, pose, slice, hash, result);
  add_query<StacklessPost>(post_a, post_b, pose, slice, hash, result);
  add_query<Leaf>(pre_a, pre_b, pose, slice, hash, result);
}

/// Prints a sum; returns whether it is the one of every core and compiler.
bool is_expected(const char* name, const Hash& sum, uint64_t expected) {
  print(name, " 0x", test::Hexadecimal(sum.value()).text);
  if (sum.value() != expected) {
    print(", expected 0x", test::Hexadecimal(expected).text);
  }
  print("\n");
  return sum.value() == expected;
}

/// Runs the fixed list of cases, with about 7 KB of static memory. Returns whether all sums are as
/// expected.
bool run(Result& result) {
  Random random(kSeed);
  Hash hash;
  Random aim(kSeed + 1);
  Hash distances;
  Random away(kSeed + 2);
  Hash far;
  Hash rays;
  for (uint32_t pair = 0; pair < kMeshPairs; ++pair) {
    const Scale& scale = kScales[pair % (sizeof kScales / sizeof kScales[0])];
    result.refused += make_side(random, scale, side_a);
    if (pair % 4 == 3) {
      side_b = side_a;  // a mesh against itself
      result.refused += make_trees(side_b, Shape::halves, 1);
    } else {
      result.refused += make_side(random, scale, side_b);
    }
    Witness<uint16_t> seed;
    Witness<uint16_t> far_seed;
    for (uint32_t i = 0; i < kPoses; ++i) {
      const uint32_t slice = i % 3 == 0 ? UINT32_MAX : 1 + random.below(20);
      const Pose pose = any_pose(random, scale);
      add_pose(pose, slice, hash, result);
      add_distance(side_a.post.view(), side_b.post.view(), pose, slice, seed, distances);
      if (i % 4 == 0) {
        add_distance(side_a.post.view(), side_b.post.view(), moved_far(away, pose), slice, far_seed,
                     far);
      }
      add_ray(side_a.post.view(), aim, scale.reach, rays);
    }
  }
  const bool intersections = is_expected("digest", hash, 0x34923EB4F3AF57C0u);
  const bool near = is_expected("distances", distances, 0x4C9B3E82605ABFFDu);
  const bool of_far = is_expected("far distances", far, 0x8F6B4A867F59BAD5u);
  return is_expected("rays", rays, 0x1BC7A7B50DE8E882u) && intersections && near && of_far;
}

}  // namespace
}  // namespace digest

int main() {
  digest::Result result = {0, 0, 0};
  const bool is_expected = digest::run(result);
  flashbvh::test::print(result.cases, " queries found ", result.pairs, " pairs\n");
  if (result.refused != 0) {
    flashbvh::test::print(result.refused, " trees refused\n");
    return 2;
  }
  if (!is_expected) {
    return 1;
  }
#if defined(FLASHBVH_ON_BOARD)
  if (port::stack_used() >= port::stack_size()) {
    flashbvh::test::print("the stack of ", port::stack_size(), " bytes overflowed\n");
    return 3;
  }
#endif
  return 0;
}
