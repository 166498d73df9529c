#include <algorithm>
#include <iostream>

#include "cli/robot/baked_robot.hpp"
#include "cli/robot/guard_output.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// In cells: rounding to the lattice moves points less than this; simplified links deviate more.
constexpr double kRounded = 2;

}  // namespace

double links_deviation(const Robot& robot) {
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < robot.link_count; ++i) {
    most = std::max<std::uint32_t>(most, robot.links[i].deviation);
  }
  return unit_length(most, cell_of(robot));
}

void print_head(const GuardedTrajectory& guarded) {
  for (const UnguardedPair& pair : guarded.unguarded) {
    std::cout << "not guarded: " << names_of(guarded.model, {pair}) << "\n";
  }
  std::cout << guarded.answers.size() << (guarded.answers.size() == 1 ? " period, " : " periods, ")
            << guarded.robot.pair_count << (guarded.robot.pair_count == 1 ? " pair" : " pairs")
            << " of links guarded\n";
  const double deviation = links_deviation(guarded.robot);
  if (deviation > kRounded * cell_of(guarded.robot)) {
    std::cout << "simplified: firmware's links and the URDF's lie within "
              << significant(deviation, 3) << " m of each other, so the guard stops up to "
              << significant(kEarlyByDeviation * deviation, 3) << " m earlier\n";
  }
  std::cout << "\n";
}

}  // namespace flashbvh::tool
