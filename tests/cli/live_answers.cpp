// live_answers ROBOT COUNT: what a guard that knows nothing yet says of values drawn at random, one
// number; and how often it says each verdict. answers.mjs gets the same of the library in a page.
#include <array>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "flashbvh/robot/guard.hpp"
#include "flashbvh/robot/image.hpp"

using namespace flashbvh;

namespace {

/// Of Numerical Recipes; 24 bits a number.
class Draws {
 public:
  std::uint32_t next() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> 8;
  }

 private:
  std::uint32_t state_ = 1;
};

class Hash {
 public:
  void add(std::uint32_t word) { value_ = (value_ ^ word) * 16777619u; }
  std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 2166136261u;
};

std::vector<std::uint64_t> words_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  std::vector<std::uint64_t> words(bytes.size() / 8 + 1);
  std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(words.data()));
  return words;
}

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
