// live_pair_answers A B: prints poses of B and rays at A, drawn at random, and the answers of
// the firmware's queries, as a script for pair_answers.js. Fails unless each kind of answer occurs.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <set>
#include <utility>
#include <variant>

#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "image/image_file.hpp"
#include "support/rotations.hpp"

using namespace flashbvh;
using test::Random;

namespace {

constexpr int kQueries = 10000;
constexpr std::int32_t kSpan = 1 << 14;  // cells, either way
constexpr double kLimit = 4096;          // cells
/// Every 16th pose, the motion from the previous pose is queried, too.
constexpr int kWays = 16;
constexpr std::uint32_t kMostWayWork = 1000000;

template <class Numbers>
void print(const Numbers& numbers) {
  for (const auto number : numbers) {
    std::cout << static_cast<std::int32_t>(number) << ",";
  }
}

/// Prints its words, too.
Pose drawn_pose(Random& random, const Mesh& a, const Mesh& b) {
  const test::Rotation rotation = rotation_of(any_quaternion(random));
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = a.origin[i] - b.origin[i] + random.between(-kSpan, kSpan);
    fraction[i] = static_cast<std::int16_t>(random.between(-32768, 32767));
    print(rotation.entry[i]);
  }
  print(cells);
  print(fraction);
  return Pose::rigid(rotation.entry, cells, fraction);
}

/// Prints its words, too.
Segment drawn_segment(Random& random, const Mesh& mesh) {
  std::int32_t ends[6];
  for (int i = 0; i < 6; ++i) {
    ends[i] = mesh.origin[i % 3] + random.between(-2 * kSpan, 2 * kSpan);
  }
  print(ends);
  return {{ends[0], ends[1], ends[2]}, {ends[3], ends[4], ends[5]}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return EXIT_FAILURE;
  }
  const tool::ImageFile images[] = {tool::ImageFile(argv[1]), tool::ImageFile(argv[2])};
  const Mesh& a = std::get<MeshWithLevels>(images[0].tree());
  const Mesh& b = std::get<MeshWithLevels>(images[1].tree());
  Random random(test::test_seed());
  Witness<std::uint16_t> hint;
  std::set<std::pair<int, bool>> kinds;
  Pose before = Pose::translated(0, 0, 0);
  const auto length = static_cast<float>(kLimit * images[0].cell());
  const FineLength limit = fine_length_rounded_up(length, cells_per_unit(a.cell_bits));
  std::cout << std::setprecision(9) << "const LIMIT = Math.fround(" << length
            << ");\nconst KNOWN = [\n";
  for (int i = 0; i < kQueries; ++i) {
    std::cout << "[[";
    const Pose pose = drawn_pose(random, a, b);
    std::cout << "],[";
    const auto hit = nearest_hit(a, drawn_segment(random, a));
    const std::uint32_t pairs = count_pairs(a, b, pose).count;
    const bool inside = pairs == 0 && one_is_inside(a, b, pose).yes;
    const auto found = distance(a, b, pose, hint);
    hint = found.witness;
    const bool closer = closer_than(a, b, pose, limit).yes;
    std::cout << "],[";
    print(std::array<std::int64_t, 10>{pairs, inside, closer, hit.yes, found.lower,
                                       found.triangles.a, found.triangles.b, found.point_a.x,
                                       found.point_b.z, hit.yes ? hit.hit.triangle : 0});
    kinds.insert({0, pairs != 0});
    kinds.insert({1, inside});
    kinds.insert({2, closer});
    kinds.insert({3, hit.yes});
    if (i % kWays == kWays - 1) {
      const BodyMotion motion = BodyMotion::between(before, pose);
      const FirstContactAnswer way = FirstContact(a, b, motion).run(kMostWayWork);
      kinds.insert({4, way.outcome == ContactOutcome::free});
      print(std::array<std::int64_t, 2>{static_cast<int>(way.outcome), way.to});
    }
    std::cout << "]],\n";
    before = pose;
  }
  std::cout << "];\n";
  return kinds.size() == 10 ? EXIT_SUCCESS : EXIT_FAILURE;
}
