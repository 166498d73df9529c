// Arbitrary calls of the C interface, with any poses, budgets, cursors and hints: each object
// returns a status, writes within its arrays and ends. The answers equal the C++ interface's, with
// any hint.
#include <vector>

#include "flashbvh/clearance.h"
#include "flashbvh/clearance.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/ray.h"
#include "flashbvh/ray.hpp"
#include "fuzz/any_pose.hpp"
#include "golden/golden.hpp"
#include "support/c_pose.hpp"

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

/// Any hint is refused, or does not change the distance.
void query_distance(const Meshes& meshes, const Pose& pose, Input& input) {
  const Mesh& a = meshes.a;
  const Mesh& b = meshes.b;
  Witness<std::uint16_t> seed;
  seed.a = input.take<std::uint16_t>();
  seed.b = input.take<std::uint16_t>();
  seed.a = static_cast<std::uint16_t>(
      input.take<std::uint8_t>() % 4 != 0 ? seed.a % a.triangle_count : seed.a);
  seed.b = static_cast<std::uint16_t>(
      input.take<std::uint8_t>() % 4 != 0 ? seed.b % b.triangle_count : seed.b);
  const auto blind = distance(a, b, pose);
  const auto seeded = distance(a, b, pose, seed);
  if (seeded.status == Status::hint_invalid) {
    require(seed.a >= a.triangle_count || seed.b >= b.triangle_count, "a good seed is refused");
    return;
  }
  require(seeded.status == blind.status && seeded.lower == blind.lower &&
              seeded.upper == blind.upper && seeded.in_range == blind.in_range,
          "a seed changes the distance");
}

void query_ray(const Meshes& meshes, Input& input) {
  const Mesh& mesh = meshes.a;
  const auto point = [&input] {
    return Point{input.take<std::int32_t>() >> 11, input.take<std::int16_t>(),
                 input.take<std::int16_t>()};
  };
  const Point from = point();
  const Segment segment = {from, point()};
  const auto seed = input.take<std::uint16_t>();
  const auto blind = nearest_hit(mesh, segment);
  const auto seeded = nearest_hit(mesh, segment, seed);
  if (seeded.status == Status::hint_invalid) {
    require(seed >= mesh.triangle_count, "a good seed of a ray is refused");
    return;
  }
  require(
      seeded.status == blind.status && seeded.yes == blind.yes &&
          (blind.status != Status::done || !blind.yes || seeded.hit.triangle == blind.hit.triangle),
      "a seed changes what a ray hits");
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
  const Pose pose = any_pose(input);
  if (pose.status() == Status::done) {
    query_pairs(meshes, c_pose_of(pose), pose, input);
  }
  query_distance(meshes, pose, input);
  query_ray(meshes, input);
  return 0;
}
