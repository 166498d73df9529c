// live_answers ROBOT: prints values of the joints, drawn at random, and the answers of an
// unprimed guard, as a script for answers.js. Fails unless each verdict occurs.
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <set>
#include <vector>

#include "flashbvh/robot/guard.hpp"
#include "robot/baked/robot_file.hpp"
#include "support/random.hpp"

using namespace flashbvh;

namespace {

constexpr int kQueries = 10000;

struct Ends {
  std::int32_t lower;
  std::int32_t upper;
};

Ends ends_of(const Robot& robot, std::uint32_t variable) {
  const RobotJoint* joint = robot.joints;
  while (joint->variable != variable || joint->shift != 0 || joint->type == JointType::fixed) {
    ++joint;
  }
  return joint->type == JointType::continuous ? Ends{-kFullTurn / 2, kFullTurn / 2}
                                              : Ends{joint->lower, joint->upper};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  const tool::RobotFile file(argv[1]);
  const Robot& robot = file.robot();
  std::cout << "const ENDS = [";
  for (std::uint32_t variable = 0; variable < robot.variable_count; ++variable) {
    const auto [lower, upper] = ends_of(robot, variable);
    std::cout << "[" << lower << "," << upper << "],";
  }
  std::cout << "];\nconst KNOWN = [\n";
  std::vector<std::uint64_t> state(100000);
  Guard guard(robot, state.data(), state.size() * 8);
  test::Random random(test::test_seed());
  std::set<Verdict> verdicts;
  for (int i = 0; i < kQueries; ++i) {
    std::vector<JointCoordinate> values;
    std::cout << "[[";
    for (std::uint32_t variable = 0; variable < robot.variable_count; ++variable) {
      const auto [lower, upper] = ends_of(robot, variable);
      values.push_back(random.between(lower, upper));
      std::cout << values.back() << ",";
    }
    const GuardAnswer answer = guard.prime(values.data());
    verdicts.insert(answer.verdict);
    std::cout << "],[" << static_cast<int>(answer.verdict) << "," << answer.pair << ","
              << answer.distance << "]],\n";
  }
  std::cout << "];\n";
  const std::set<Verdict> wanted = {Verdict::free, Verdict::warn, Verdict::stop};
  return verdicts == wanted ? EXIT_SUCCESS : EXIT_FAILURE;
}
