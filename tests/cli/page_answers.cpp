// page_answers ROBOT, or A B: prints, as JSON for answers.mjs, values of a robot's joints with the
// answers of an unprimed guard, or poses of B with the answers of the queries, drawn at random.
// Fails unless each kind of answer occurs.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "flashbvh/clearance.hpp"
#include "flashbvh/first_contact.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/solid.hpp"
#include "image/image_file.hpp"
#include "robot/baked/robot_file.hpp"
#include "support/rotations.hpp"
#include "text/numbers.hpp"

using namespace flashbvh;
using test::Random;

namespace {

constexpr int kQueries = 10000;
constexpr std::int32_t kSpan = 1 << 14;  // cells, either way
/// Every 16th pose, the motion from the previous pose is queried, too.
constexpr int kWays = 16;
constexpr std::uint32_t kMostWayWork = 1000000;

using Words = std::vector<std::int32_t>;

std::string list(const Words& words) {
  return "[" +
         tool::joined(
             words, [](std::int32_t word) { return std::to_string(word); }, ",") +
         "]";
}

void print(int number, const Words& query, const Words& answer) {
  std::cout << (number == 0 ? "" : ",\n") << "[" << list(query) << "," << list(answer) << "]";
}

Words ends_of(const Robot& robot, std::uint32_t variable) {
  const RobotJoint* joint = robot.joints;
  while (joint->variable != variable || joint->shift != 0 || joint->type == JointType::fixed) {
    ++joint;
  }
  return joint->type == JointType::continuous ? Words{-kFullTurn / 2, kFullTurn / 2}
                                              : Words{joint->lower, joint->upper};
}

bool print_robot(const Robot& robot) {
  std::vector<std::uint64_t> state(100000);
  Guard guard(robot, state.data(), state.size() * 8);
  Random random(test::test_seed());
  std::set<Verdict> verdicts;
  std::vector<Words> ends;
  for (std::uint32_t variable = 0; variable < robot.variable_count; ++variable) {
    ends.push_back(ends_of(robot, variable));
  }
  std::cout << "{\"ends\":[" << tool::joined(ends, list, ",") << "],\"queries\":[\n";
  for (int i = 0; i < kQueries; ++i) {
    Words values;
    for (const Words& two : ends) {
      values.push_back(random.between(two[0], two[1]));
    }
    GuardAnswer answer = guard.prime(values.data());
    answer.verdict = answer.verdict == Verdict::leaving ? Verdict::stop : answer.verdict;
    verdicts.insert(answer.verdict);
    const bool has_pair = answer.pair != kNoPair;
    print(i, values,
          {static_cast<std::int32_t>(answer.verdict), has_pair ? robot.pairs[answer.pair].a : -1,
           has_pair ? robot.pairs[answer.pair].b : -1, static_cast<std::int32_t>(answer.distance)});
  }
  return verdicts == std::set<Verdict>{Verdict::free, Verdict::warn, Verdict::stop};
}

Pose drawn_pose(Random& random, const Mesh& a, const Mesh& b, Words& words) {
  const test::Rotation rotation = rotation_of(any_quaternion(random));
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = a.origin[i] - b.origin[i] + random.between(-kSpan, kSpan);
    fraction[i] = static_cast<std::int16_t>(random.between(-32768, 32767));
    words.insert(words.end(), rotation.entry[i], rotation.entry[i] + 3);
  }
  words.insert(words.end(), cells, cells + 3);
  words.insert(words.end(), fraction, fraction + 3);
  return Pose::rigid(rotation.entry, cells, fraction);
}

bool print_pair(const Mesh& a, const Mesh& b) {
  Random random(test::test_seed());
  Witness<std::uint16_t> hint;
  std::set<std::pair<int, std::int32_t>> kinds;
  Pose before = Pose::translated(0, 0, 0);
  std::cout << "{\"queries\":[\n";
  for (int i = 0; i < kQueries; ++i) {
    Words words;
    const Pose pose = drawn_pose(random, a, b, words);
    const auto pairs = static_cast<std::int32_t>(count_pairs(a, b, pose).count);
    const bool are_closed = a.is_closed && b.is_closed;
    const std::int32_t inside = pairs != 0 ? 0 : !are_closed ? 2 : one_is_inside(a, b, pose).yes;
    const auto found = distance(a, b, pose, hint);
    hint = found.witness;
    Words answer = {pairs,
                    inside,
                    static_cast<std::int32_t>(found.lower),
                    static_cast<std::int32_t>(found.triangles.a),
                    static_cast<std::int32_t>(found.triangles.b),
                    static_cast<std::int32_t>(found.point_a.x),
                    static_cast<std::int32_t>(found.point_b.z)};
    kinds.insert({0, pairs != 0});
    kinds.insert({1, inside});
    if (i % kWays == kWays - 1) {
      const BodyMotion motion = BodyMotion::between(before, pose);
      const FirstContactAnswer way = FirstContact(a, b, motion).run(kMostWayWork);
      answer.push_back(static_cast<std::int32_t>(way.outcome));
      answer.push_back(static_cast<std::int32_t>(way.to));
      kinds.insert({2, way.outcome == ContactOutcome::free});
    }
    print(i, words, answer);
    before = pose;
  }
  return kinds.size() == 6;
}

}  // namespace

int main(int argc, char** argv) {
  bool is_varied = false;
  if (argc == 2) {
    is_varied = print_robot(tool::RobotFile(argv[1]).robot());
  } else if (argc == 3) {
    const tool::ImageFile a(argv[1]);
    const tool::ImageFile b(argv[2]);
    is_varied = print_pair(std::get<MeshWithLevels>(a.tree()), std::get<MeshWithLevels>(b.tree()));
  }
  std::cout << "\n]}\n";
  return is_varied ? EXIT_SUCCESS : EXIT_FAILURE;
}
