#include "robot/pipeline/divide.hpp"

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A share of a joint's range that is much to lose.
constexpr double kMuchOfJoint = 0.05;

/// Warns of pairs with their own distances that no joint moves.
void warn_of_fixed(const Divided& robot, const std::string& path, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.verdict == MatrixVerdict::fixed &&
        find_pair(robot.distances.own, pair.a, pair.b) != nullptr) {
      warnings.add(path, concat("links '", robot.model.links[pair.a].name, "' and '",
                                robot.model.links[pair.b].name,
                                "' have a --pair, but no joint moves them; leave it out"));
    }
  }
}

std::string way_out(const PairVerdict& pair, const std::string& a, const std::string& b) {
  return "disable the pair in an SRDF" + (pair.verdict != MatrixVerdict::never
                                              ? concat(" and name it by --believe ", a, ",", b)
                                              : "");
}

/// UserError if limit() could let no arm out from between two links.
void check_limits(const Divided& robot, const RobotRequest& request) {
  for (const PairVerdict& pair : robot.pairs) {
    if (request.limits && (pair.is_stopped || pair.share() == 1)) {
      const std::string& a = robot.model.links[pair.a].name;
      const std::string& b = robot.model.links[pair.b].name;
      throw UserError(request.urdf, "--limit: links '", a, "' and '", b,
                      "' are nowhere found farther apart than their stop distance, ",
                      shortest(robot.distances.of(pair.a, pair.b).stop),
                      " m, and a tenth; limit() could never let them out; lower it (--stop, "
                      "--pair), or ",
                      way_out(pair, a, b));
    }
  }
}

/// Warns of neighbours that stop a guard in much of their joint's range.
void warn_of_shares(const Divided& robot, const std::string& path, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.share() > kMuchOfJoint) {
      const std::string& a = robot.model.links[pair.a].name;
      const std::string& b = robot.model.links[pair.b].name;
      const std::string& joint = robot.model.joints[robot.zones[*pair.zone].joint].name;
      warnings.add(
          path, concat("links '", a, "' and '", b, "' outside their joint's zone stop a guard in ",
                       significant(100 * pair.share(), 2), " % of the range of '", joint,
                       "'; give a larger --zone ", joint, "=LENGTH, or ", way_out(pair, a, b)));
    }
  }
}

/// Warns of pairs for which a guard would report one verdict in all configurations.
void warn_of_near(const Divided& robot, const RobotRequest& request, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (!pair.is_stopped && !pair.is_warned) {
      continue;
    }
    const bool is_own = find_pair(robot.distances.own, pair.a, pair.b) != nullptr;
    const GuardedPair of = robot.distances.of(pair.a, pair.b);
    const double distance = pair.is_stopped ? of.stop : of.warn;
    const char* const word = pair.is_stopped ? "stop" : "warn";
    const std::string& a = robot.model.links[pair.a].name;
    const std::string& b = robot.model.links[pair.b].name;
    const std::string early = significant(robot.options.early * robot.cell, 3);
    const std::string near =
        concat("links '", a, "' and '", b, "' are nowhere found farther apart than the ", word,
               " distance, ", shortest(distance), " m",
               pair.is_stopped && robot.options.early > 0
                   ? concat(" and ", early, " m that simplified links may stop earlier")
                   : "");
    if (!pair.is_stopped && !is_own) {
      warnings.add(request.urdf, concat(near, ", so they are not warned of; --pair ", a, ",", b,
                                        "=STOP,WARN warns"));
      continue;
    }
    std::string remedies = distance != 0 ? concat("lower it (--", word, ", --pair), or ")
                           : is_own      ? "leave out its --pair, or "
                                         : "";
    remedies += way_out(pair, a, b);
    warnings.add(request.urdf,
                 concat(near, ", so a guard would ",
                        pair.is_stopped ? "always say stop; " : "never say free; ", remedies));
  }
}

}  // namespace

void warn_of_guard(const Divided& robot, const RobotRequest& request, Warnings& warnings) {
  check_limits(robot, request);
  warn_of_unguarded(robot.model, robot.unguarded, request.urdf, warnings);
  warn_of_fixed(robot, request.urdf, warnings);
  warn_of_shares(robot, request.urdf, warnings);
  warn_of_near(robot, request, warnings);
}

}  // namespace flashbvh::tool
