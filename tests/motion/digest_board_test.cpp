// One number for many motions, equal on every core and with every compiler.
#include <catch2/catch.hpp>
#include <initializer_list>

#include "digest/digest.hpp"
#include "digest/small_mesh.hpp"
#include "flashbvh/first_contact.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr int kMotions = 1000;
constexpr uint32_t kMovesAtMost = 3;

[[gnu::noinline]] Move any_move(Random& random, const digest::Scale& scale) {
  Move move = {};
  const Rotation rotation = rotation_of(any_quaternion(random));
  const int32_t most = random.below(3) == 0 ? 3 * kFullTurn : kFullTurn / 8;
  move.turn = random.below(4) == 0 ? 0 : random.between(-most, most);
  for (int i = 0; i < 3; ++i) {
    move.axis[i] = rotation.entry[i][0];
    move.point[i] = random.between(-scale.reach, scale.reach) * kFrameCell;
    move.travel[i] =
        random.below(2) == 0 ? 0 : random.between(-scale.reach, scale.reach) * kFrameCell / 2;
  }
  return move;
}

// A mesh and another tree of it; static, since the smallest core's stack is too small.
digest::SmallMesh mesh;

struct Scene {
  digest::SmallTree<Layout::post_indexed> a, b;

  Scene(Random& random, const digest::Scale& scale) {
    digest::make_mesh(random, scale, mesh);
    for (auto* const tree : {&a, &b}) {
      const auto shape = static_cast<digest::Shape>(random.below(4));
      REQUIRE(tree->make(mesh, shape, 1 + random.below(3)));
    }
  }
};

/// Adds the contacts in slices, whose number must be equal on all cores. Passes each `close`.
[[gnu::noinline]] void add_contacts(FirstContact& query, uint32_t slice, digest::Hash& hash,
                                    int (&outcomes)[3]) {
  for (;;) {
    uint32_t runs = 1;
    FirstContactAnswer answer = query.run(slice);
    for (; answer.status == Status::suspended; ++runs) {
      answer = query.run(slice);
    }
    hash.add(runs);
    ++outcomes[static_cast<int>(answer.outcome)];
    hash.add(static_cast<uint32_t>(answer.status) | static_cast<uint32_t>(answer.outcome) << 8);
    hash.add(answer.triangles.a | static_cast<uint32_t>(answer.triangles.b) << 16);
    hash.add(answer.from);
    hash.add(answer.to);
    if (answer.status != Status::done || answer.outcome != ContactOutcome::close) {
      return;
    }
    query.pass();
  }
}

[[gnu::noinline]] void add_pose(const Pose& pose, digest::Hash& hash) {
  for (int i = 0; i < 3; ++i) {
    hash.add(static_cast<uint32_t>(pose.translation(i)));
    hash.add(static_cast<uint32_t>(pose.fraction(i)));
    hash.add(static_cast<uint32_t>(pose.rotation(i, i)));
  }
}

}  // namespace

TEST_CASE("small trees: first contacts of motions are every core's") {
  Random random(6);
  digest::Hash hash;
  int outcomes[3] = {};
  for (int round = 0; round < kMotions; ++round) {
    const digest::Scale& scale = digest::kScales[static_cast<uint32_t>(round) % 5];
    const Scene scene(random, scale);
    const Pose from = digest::any_pose(random, scale);
    Move moves[kMovesAtMost];
    const uint32_t count = random.below(kMovesAtMost + 1);
    for (uint32_t i = 0; i < count; ++i) {
      moves[i] = any_move(random, scale);
    }
    const Mesh& a = scene.a.view();
    const Mesh& b = scene.b.view();
    const BodyMotion motion = count == 0
                                  ? BodyMotion::between(from, digest::any_pose(random, scale))
                                  : BodyMotion(from, moves, count);
    add_pose(motion.pose_at(random.below(kMotionEnd)), hash);
    FirstContact query(a, b, motion, {random.below(2) * 1000});
    add_contacts(query, 1 + random.below(1000), hash, outcomes);
  }
  CHECK(outcomes[0] > 10);
  CHECK(outcomes[1] > 10);
  CHECK(outcomes[2] > 10);
  CHECK(hash.value() == 0xEBB8CAFFC99C9628u);
}
