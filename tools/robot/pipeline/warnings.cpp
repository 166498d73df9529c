#include "robot/pipeline/warnings.hpp"

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Warns of pairs with their own distances that no joint moves.
void warn_of_fixed(const Divided& robot, const AllDistances& distances, const std::string& path,
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

/// Warns of pairs for which a guard would report one verdict in all configurations.
void warn_of_near(const Divided& robot, const AllDistances& distances, const RobotRequest& request,
                  Warnings& warnings) {
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
      warnings.add(request.urdf,
                   concat(links, "they are not warned of; --pair ", names, "=STOP,WARN warns"));
      continue;
    }
    const char* const word = pair.is_stopped ? "stop" : "warn";
    warnings.add(
        request.urdf,
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

}  // namespace

void warn_of_unguarded(const Model& model, const std::vector<UnguardedPair>& unguarded,
                       const std::string& path, Warnings& warnings) {
  for (const std::string& warning : unguarded_warnings(model, unguarded)) {
    warnings.add(path, warning);
  }
}

void warn_of_guard(const Divided& robot, const AllDistances& distances, const RobotRequest& request,
                   Warnings& warnings) {
  warn_of_unguarded(robot.model, robot.unguarded, request.urdf, warnings);
  warn_of_fixed(robot, distances, request.urdf, warnings);
  warn_of_near(robot, distances, request, warnings);
}

void warn_of_late_zones(const Model& model, const Decided& decided, const std::string& path,
                        const std::string& then, Warnings& warnings) {
  std::string joints;
  for (const std::size_t joint : decided.late_joints) {
    joints += concat(joints.empty() ? "" : ", ", model.joints[joint].name);
  }
  if (!joints.empty()) {
    warnings.add(path, concat("no time was left to find a zone about ", joints,
                              ": links that touch there are ", then, "; give more --time"));
  }
}

}  // namespace flashbvh::tool
