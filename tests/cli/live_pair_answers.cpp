// live_pair_answers A B COUNT: hashes the answers of the firmware's queries for B at random poses
// and for rays at A into one number, and counts the kinds of answers. pair_answers.js computes the
// answers of the library in a page.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "draws.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"

using namespace flashbvh;

namespace {

constexpr std::int32_t kSpan = 1 << 14;  // cells, either way
constexpr std::uint32_t kLimit = 1 << 20;
/// Every 16th pose, the motion from the previous pose is queried, too.
constexpr int kWays = 16;
constexpr std::uint32_t kMostWayWork = 1000000;

/// A number from 0 to `end` - 1.
std::int64_t below(Draws& draws, std::int64_t end) {
  return draws.next() * end >> 24;
}

/// A pose whose rotation is a quaternion of four integers.
Pose drawn_pose(Draws& draws, const Mesh& a, const Mesh& b) {
  std::int64_t w = below(draws, 2001) - 1000;
  const std::int64_t x = below(draws, 2001) - 1000;
  const std::int64_t y = below(draws, 2001) - 1000;
  const std::int64_t z = below(draws, 2001) - 1000;
  w += w == 0;
  const std::int64_t square = w * w + x * x + y * y + z * z;
  const std::int64_t over[3][3] = {
      {w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w)},
      {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w)},
      {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z}};
  std::int32_t rotation[3][3];
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      rotation[i][j] = static_cast<std::int32_t>(over[i][j] * kRotationOne / square);
    }
    cells[i] =
        static_cast<std::int32_t>(a.origin[i] - b.origin[i] - kSpan + below(draws, 2 * kSpan));
    fraction[i] = static_cast<std::int16_t>(below(draws, 65536) - 32768);
  }
  return Pose::rigid(rotation, cells, fraction);
}

Segment drawn_segment(Draws& draws, const Mesh& mesh) {
  std::int32_t ends[6];
  for (int i = 0; i < 6; ++i) {
    ends[i] = static_cast<std::int32_t>(mesh.origin[i % 3] - 2 * kSpan + below(draws, 4 * kSpan));
  }
  return {{ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    return EXIT_FAILURE;
  }
  const std::vector<std::uint64_t> images[] = {words_of(argv[1]), words_of(argv[2])};
  Mesh a;
  Mesh b;
  if (open_image(images[0].data(), images[0].size() * 8, a) != Status::done ||
      open_image(images[1].data(), images[1].size() * 8, b) != Status::done) {
    return EXIT_FAILURE;
  }
  Draws draws;
  Hash hash;
  Witness<std::uint16_t> hint;
  int counts[5] = {};
  Pose before = Pose::translated(0, 0, 0);
  for (int i = 0; i < std::atoi(argv[3]); ++i) {
    const Pose pose = drawn_pose(draws, a, b);
    const std::uint32_t pairs = count_pairs(a, b, pose).count;
    const bool inside = pairs == 0 && one_is_inside(a, b, pose).yes;
    const auto found = distance(a, b, pose, hint);
    hint = found.witness;
    const bool closer = closer_than(a, b, pose, kLimit).yes;
    const auto hit = nearest_hit(a, drawn_segment(draws, a));
    counts[0] += pairs != 0;
    counts[1] += inside;
    counts[2] += closer;
    counts[3] += hit.yes;
    for (const std::uint32_t word :
         {pairs, std::uint32_t{inside}, found.lower, std::uint32_t{found.triangles.a},
          std::uint32_t{found.triangles.b}, static_cast<std::uint32_t>(found.point_a.x),
          static_cast<std::uint32_t>(found.point_b.z), std::uint32_t{closer},
          hit.yes ? hit.hit.triangle + 1u : 0u}) {
      hash.add(word);
    }
    if (i % kWays == kWays - 1) {
      const BodyMotion motion = BodyMotion::between(before, pose);
      const FirstContactAnswer way = FirstContact(a, b, motion).run(kMostWayWork);
      counts[4] += way.outcome == ContactOutcome::free;
      hash.add(static_cast<std::uint32_t>(way.outcome));
      hash.add(way.to);
    }
    before = pose;
  }
  std::cout << hash.value() << ": " << counts[0] << " intersect, " << counts[1] << " inside, "
            << counts[2] << " closer, " << counts[3] << " hit, " << counts[4] << " ways free\n";
  return EXIT_SUCCESS;
}
