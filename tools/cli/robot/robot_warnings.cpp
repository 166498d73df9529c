#include "cli/robot/robot_warnings.hpp"

#include "text/numbers.hpp"

namespace flashbvh::tool {

void warn_of_fixed(const BakedRobot& robot, const AllDistances& distances, const std::string& path,
                   Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.verdict == MatrixVerdict::fixed &&
        find_pair(distances.own, pair.a, pair.b) != nullptr) {
      warnings.add(path, concat("links '", robot.model.links[pair.a].name, "' and '",
                                robot.model.links[pair.b].name,
                                "' have a --pair, but no joint moves them; leave it out"));
    }
  }
}

void warn_of_unguarded(const BakedRobot& robot, const std::string& path, Warnings& warnings) {
  for (const std::string& warning : unguarded_warnings(robot.model, robot.unguarded)) {
    warnings.add(path, warning);
  }
}

void warn_of_near(const BakedRobot& robot, const AllDistances& distances,
                  const RobotArguments& arguments, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (!pair.is_stopped && !pair.is_warned) {
      continue;
    }
    const GuardedPair* const own = find_pair(distances.own, pair.a, pair.b);
    const auto [stop, warn] = distances_of(distances, pair);
    const std::string names =
        concat(robot.model.links[pair.a].name, ",", robot.model.links[pair.b].name);
    const std::string links =
        concat("links '", robot.model.links[pair.a].name, "' and '", robot.model.links[pair.b].name,
               "'", pair.zone ? " outside their joint's zone" : "",
               " are nowhere found farther apart than the ", pair.is_stopped ? "stop" : "warn",
               " distance, ", shortest(pair.is_stopped ? stop : warn), " m",
               pair.is_stopped && robot.options.early > 0
                   ? concat(" and ", significant(robot.options.early * robot.cell, 3),
                            " m that simplified links may stop earlier")
                   : "",
               ", so ");
    if (!pair.is_stopped && own == nullptr) {
      warnings.add(arguments.urdf,
                   concat(links, "they are not warned of; --pair ", names, "=STOP,WARN warns"));
      continue;
    }
    const char* const word = pair.is_stopped ? "stop" : "warn";
    warnings.add(
        arguments.urdf,
        concat(links, "a guard would ", pair.is_stopped ? "always say stop; " : "never say free; ",
               pair.zone ? "give the joint a larger --zone, or " : "",
               (pair.is_stopped ? stop : warn) != 0 ? concat("lower it (--", word, ", --pair), or ")
               : own != nullptr                     ? "leave out its --pair, or "
                                                    : "",
               "disable the pair in an SRDF",
               pair.verdict == MatrixVerdict::never ? ""
                                                    : concat(" and name it by --believe ", names)));
  }
}

void warn_of_late_zones(const BakedRobot& robot, const std::string& path, const std::string& then,
                        Warnings& warnings) {
  std::string joints;
  for (const std::size_t joint : robot.late_joints) {
    joints += concat(joints.empty() ? "" : ", ", robot.model.joints[joint].name);
  }
  if (!joints.empty()) {
    warnings.add(path, concat("no time was left to find a zone about ", joints,
                              ": links that touch there are ", then, "; give more --time"));
  }
}

}  // namespace flashbvh::tool
