// Calls of the C interface with any poses, budgets, cursors and hints: pairs of triangles, a
// distance and a ray. Each returns a status, writes within its arrays and ends. The answers equal
// the C++ interface's, but after a changed cursor the pairs may be any. A hint is refused or does
// not change an answer.

#include "flashbvh/clearance.hpp"
#include "flashbvh/flashbvh.h"
#include "flashbvh/image.hpp"
#include "flashbvh/ray.hpp"
#include "fuzz/any_pose.hpp"
#include "golden/golden.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

struct Meshes {
  Mesh a;
  Mesh b;
  flashbvh_mesh c_a;
  flashbvh_mesh c_b;

  bool open(const KeptImage& of_a, const KeptImage& of_b) {
    return open_image(of_a.bytes, of_a.size, a) == Status::done &&
           open_image(of_b.bytes, of_b.size, b) == Status::done && open_c(of_a, c_a) &&
           open_c(of_b, c_b);
  }
  static bool open_c(const KeptImage& image, flashbvh_mesh& mesh) {
    return flashbvh_open(image.bytes, image.size, &mesh) == FLASHBVH_STATUS_DONE;
  }
};

constexpr std::uint32_t kRoom = 8;

/// Queries in slices of any size, sometimes resumed at its own cursor or at any other.
void query_pairs(const Meshes& meshes, const flashbvh_pose& pose, const Pose& same, Input& input) {
  flashbvh_query query;
  std::memset(&query, 0xA5, sizeof query);
  flashbvh_status status = flashbvh_query_start(&query, &meshes.c_a, &meshes.c_b, &pose);
  std::uint32_t found = 0;
  bool is_its_own = true;
  for (std::uint32_t run = 0; status == FLASHBVH_STATUS_SUSPENDED || status == FLASHBVH_STATUS_FULL;
       ++run) {
    const std::uint32_t work = run < 20 ? input.take<std::uint8_t>() : UINT32_MAX;
    const std::uint32_t room = run < 20 ? work % (kRoom + 1) : kRoom;
    flashbvh_pair pairs[kRoom + 1];
    std::memset(pairs, 0xA5, sizeof pairs);
    const flashbvh_run_result step = flashbvh_query_run(&query, work, pairs, room);
    status = static_cast<flashbvh_status>(step.status);
    const std::uint32_t count = step.count;
    require(count <= room && pairs[room].a == 0xA5A5, "pairs beyond the array");
    found += count;
    flashbvh_cursor position = flashbvh_query_cursor(&query);
    if (run < 20 && work % 16 == 15) {
      position.a = static_cast<std::uint16_t>(position.a ^ input.take<std::uint8_t>());
      position.b = static_cast<std::uint16_t>(position.b ^ input.take<std::uint8_t>());
      position.untested ^= input.take<std::uint8_t>();
      is_its_own = false;
      (void)flashbvh_query_start(&query, &meshes.c_a, &meshes.c_b, &pose);
      status = flashbvh_query_resume(&query, &position);
    }
  }
  PairQuery reference(meshes.a, meshes.b, same);
  std::uint32_t all = 0;
  const Status ended = reference
                           .run(UINT32_MAX,
                                [&](const PairQuery::Pair&) {
                                  ++all;
                                  return true;
                                })
                           .status;
  require(!is_its_own || (static_cast<int>(ended) == status && all == found),
          "C gives another answer than C++");
}

template <class Coordinates, class Same>
bool are_equal(const Coordinates& c, const Same& cpp) {
  return c.x == cpp.x && c.y == cpp.y && c.z == cpp.z;
}

bool are_equal(const flashbvh_clearance& c, const Clearance<std::uint16_t>& cpp) {
  return c.status == static_cast<flashbvh_status>(cpp.status) && c.in_range == cpp.in_range &&
         c.lower == cpp.lower && c.upper == cpp.upper && c.triangles.a == cpp.triangles.a &&
         c.triangles.b == cpp.triangles.b && c.witness.a == cpp.witness.a &&
         c.witness.b == cpp.witness.b && are_equal(c.point_a, cpp.point_a) &&
         are_equal(c.point_b, cpp.point_b) && are_equal(c.direction, cpp.direction);
}

/// The distance by C++, after it was compared with C's.
Clearance<std::uint16_t> distance_by_both(const Meshes& meshes, const flashbvh_pose& pose,
                                          const Pose& same, const flashbvh_witness* hint) {
  const Witness<std::uint16_t> its_hint =
      hint == nullptr ? Witness<std::uint16_t>() : Witness<std::uint16_t>{hint->a, hint->b};
  const auto found = distance(meshes.a, meshes.b, same, its_hint);
  flashbvh_clearance result;
  std::memset(&result, 0xA5, sizeof result);
  const flashbvh_status status = flashbvh_distance(&meshes.c_a, &meshes.c_b, &pose, hint, &result);
  require(status == static_cast<flashbvh_status>(found.status), "C ends otherwise than C++");
  require(found.status != Status::done || are_equal(result, found),
          "C gives another distance than C++");
  return found;
}

void query_distance(const Meshes& meshes, const flashbvh_pose& pose, const Pose& same,
                    Input& input) {
  const std::uint32_t count_a = meshes.a.triangle_count;
  const std::uint32_t count_b = meshes.b.triangle_count;
  flashbvh_witness hint;
  hint.a = input.take<std::uint16_t>();
  hint.b = input.take<std::uint16_t>();
  hint.a =
      static_cast<std::uint16_t>(input.take<std::uint8_t>() % 4 != 0 ? hint.a % count_a : hint.a);
  hint.b =
      static_cast<std::uint16_t>(input.take<std::uint8_t>() % 4 != 0 ? hint.b % count_b : hint.b);
  const auto blind = distance_by_both(meshes, pose, same, nullptr);
  const auto hinted = distance_by_both(meshes, pose, same, &hint);
  if (hinted.status == Status::hint_invalid) {
    require(hint.a >= count_a || hint.b >= count_b, "a good hint is refused");
    return;
  }
  require(hinted.status == blind.status &&
              (blind.status != Status::done ||
               (hinted.lower == blind.lower && hinted.upper == blind.upper &&
                hinted.in_range == blind.in_range)),
          "a hint changes the distance");
}

bool are_equal(const flashbvh_hit& c, const RayHit<std::uint16_t>& cpp) {
  return c.above == cpp.along.above && c.below == cpp.along.below && c.triangle == cpp.triangle &&
         c.slot == cpp.slot && c.side == cpp.side;
}

/// The ray's hit by C++, after it was compared with C's.
RayAnswer<std::uint16_t> hit_by_both(const Meshes& meshes, const Segment& segment,
                                     std::uint16_t hint) {
  const auto found = nearest_hit(meshes.a, segment, hint);
  flashbvh_hit hit;
  std::memset(&hit, 0xA5, sizeof hit);
  bool yes = false;
  const flashbvh_status status = flashbvh_nearest_hit(&meshes.c_a, &segment, hint, &yes, &hit);
  require(status == static_cast<flashbvh_status>(found.status) && yes == found.yes,
          "C's ray ends otherwise than C++'s");
  require(found.status != Status::done || !found.yes || are_equal(hit, found.hit),
          "C's ray hits otherwise than C++'s");
  return found;
}

void query_ray(const Meshes& meshes, Input& input) {
  const auto point = [&input] {
    return Point{input.take<std::int32_t>() >> 11, input.take<std::int16_t>(),
                 input.take<std::int16_t>()};
  };
  const Point from = point();
  const Segment segment = {from, point()};
  const auto hint = input.take<std::uint16_t>();
  const auto blind = hit_by_both(meshes, segment, FLASHBVH_NO_HINT);
  const auto hinted = hit_by_both(meshes, segment, hint);
  if (hinted.status == Status::hint_invalid) {
    require(hint >= meshes.a.triangle_count, "a good hint of a ray is refused");
    return;
  }
  require(
      hinted.status == blind.status && hinted.yes == blind.yes &&
          (blind.status != Status::done || !blind.yes || hinted.hit.triangle == blind.hit.triangle),
      "a hint changes what a ray hits");
}

/// Makes the pose in C, a translation with the identity as rotation.
flashbvh_status make_pose(PoseNumbers numbers, flashbvh_pose& pose) {
  if (!numbers.is_turned) {
    numbers.rotation[0][0] = numbers.rotation[1][1] = numbers.rotation[2][2] = kRotationOne;
  }
  std::memset(&pose, 0xA5, sizeof pose);
  return flashbvh_pose_rigid(numbers.rotation[0], numbers.cells,
                             numbers.is_turned ? numbers.fraction : nullptr, &pose);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Input input(bytes, size);
  const auto chosen = input.take<std::uint8_t>();
  Meshes meshes;
  if (!meshes.open(kKeptImages[(chosen & 15u) % kKeptImageCount],
                   kKeptImages[(chosen >> 4u) % kKeptImageCount])) {
    return 0;
  }
  const PoseNumbers numbers = any_pose_numbers(input);
  const Pose pose = numbers.pose();
  flashbvh_pose c_pose;
  require(make_pose(numbers, c_pose) == static_cast<flashbvh_status>(pose.status()),
          "C's pose has another status than C++'s");
  query_pairs(meshes, c_pose, pose, input);
  query_distance(meshes, c_pose, pose, input);
  query_ray(meshes, input);
  return 0;
}
