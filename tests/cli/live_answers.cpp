// live_answers ROBOT COUNT: hashes the answers of an unprimed guard for random values into one
// number, and counts each verdict. answers.mjs prints the answers of the library in a page.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "draws.hpp"
#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"

using namespace flashbvh;

namespace {

JointCoordinate drawn(Draws& draws, const Robot& robot, std::uint32_t variable) {
  const RobotJoint* joint = robot.joints;
  while (joint->variable != variable || joint->shift != 0 || joint->type == JointType::fixed) {
    ++joint;
  }
  const bool turns = joint->type == JointType::continuous;
  const std::int64_t lower = turns ? -kFullTurn / 2 : joint->lower;
  const std::int64_t upper = turns ? kFullTurn / 2 : joint->upper;
  return static_cast<JointCoordinate>(lower + ((upper - lower) * draws.next() >> 24));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    return EXIT_FAILURE;
  }
  const std::vector<std::uint64_t> image = words_of(argv[1]);
  std::array<Mesh, 64> meshes;
  Robot robot{};
  if (open_robot(image.data(), image.size() * 8, meshes.data(), meshes.size(), robot) !=
      Status::done) {
    return EXIT_FAILURE;
  }
  std::vector<std::uint64_t> state(100000);
  Guard guard(robot, state.data(), state.size() * 8);
  Draws draws;
  Hash hash;
  std::array<int, 5> verdicts{};
  for (int i = 0; i < std::atoi(argv[2]); ++i) {
    std::vector<JointCoordinate> values(robot.variable_count);
    for (std::uint32_t variable = 0; variable < robot.variable_count; ++variable) {
      values[variable] = drawn(draws, robot, variable);
    }
    const GuardAnswer answer = guard.prime(values.data());
    ++verdicts.at(static_cast<std::size_t>(answer.verdict));
    hash.add(static_cast<std::uint32_t>(answer.verdict));
    hash.add(answer.pair);
    hash.add(answer.distance);
  }
  std::cout << hash.value() << ": " << verdicts[0] << " free, " << verdicts[1] << " warn, "
            << verdicts[3] << " stop\n";
  return EXIT_SUCCESS;
}
