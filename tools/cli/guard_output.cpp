#include "cli/guard_output.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/lengths.hpp"
#include "robot/replay_summary.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

using Json = nlohmann::ordered_json;

/// Lines that are told one by one in tables and on standard error.
constexpr std::size_t kShownLines = 10;

const char* name_of(Verdict verdict) {
  constexpr const char* kNames[] = {"free", "warn", "not_yet_known", "stop", "refused"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string name_of(Status status) {
  switch (status) {
    case Status::done:
      return "ok";
    case Status::not_a_coordinate:
      return "not_a_coordinate";
    case Status::joint_out_of_limits:
      return "joint_out_of_limits";
    case Status::joint_jumped:
      return "joint_jumped";
    default:
      return concat("status ", static_cast<int>(status));
  }
}

const std::string& link_name(const BakedRobot& robot, std::uint8_t link) {
  return robot.model.links[link].name;
}

std::string links_of(const BakedRobot& robot, std::uint16_t pair) {
  const RobotPair& links = robot.robot().pairs[pair];
  return link_name(robot, links.a) + " - " + link_name(robot, links.b);
}

const std::string& variable_name(const BakedRobot& robot, std::size_t variable) {
  return robot.model.joints[robot.model.variables[variable]].name;
}

/// What is wrong with the values of a period, and the mend.
std::string why_refused(const Replayed& replayed, std::size_t period) {
  const Status status = replayed.answers[period].status;
  if (status == Status::joint_jumped) {
    return "a joint without limits turns by half a turn, which may be either way; give values in "
           "between";
  }
  if (status != Status::joint_out_of_limits && status != Status::not_a_coordinate) {
    return concat("the guard can't go on: ", name_of(status));
  }
  const float* const values = replayed.trajectory.values(period);
  const BakedRobot& robot = replayed.robot;
  const ModelJoint& joint = robot.model.joints[refused_joint(robot.robot(), values)];
  const std::string& master = variable_name(robot, joint.variable);
  const std::string told =
      concat("joint '", joint.name, joint.name == master ? "' can't be at " : "' can't follow '",
             joint.name == master ? "" : master + "' to ",
             significant(static_cast<double>(values[joint.variable]), 6), ": ");
  return status == Status::not_a_coordinate
             ? told + "firmware takes less than 8 turns; leave full turns out"
             : told + concat("its limits are ", significant(joint.lower, 6), " and ",
                             significant(joint.upper, 6), "; mend the value, or the URDF");
}

void print_counts(const Replayed& replayed) {
  const ReplaySummary counts = summary_of(replayed.answers);
  for (const std::size_t kind : kKindsInOrder) {
    std::cout << std::left << std::setw(15) << kKindNames[kind] << std::right << std::setw(9)
              << counts.periods[kind];
    if (kind != 0 && counts.periods[kind] != 0) {
      const std::size_t first = counts.first[kind];
      const std::uint16_t pair = replayed.answers[first].pair;
      std::cout << "  first at line " << replayed.trajectory.line(first)
                << (kind == kRefusedKind || pair == kNoPair
                        ? ""
                        : ", " + links_of(replayed.robot, pair));
    }
    std::cout << "\n";
  }
}

void print_closest(const Replayed& replayed) {
  const auto closest = closest_moment(replayed.robot.robot(), replayed.trajectory);
  if (!closest) {
    return;
  }
  const double distance = unit_length(closest->clearance.lower, replayed.robot.cell);
  std::cout << "\nclosest: line " << replayed.trajectory.line(closest->period) << ", "
            << links_of(replayed.robot, closest->pair)
            << (distance == 0 ? " intersect" : ", " + significant(distance, 4) + " m") << "\n";
}

void print_work(const Replayed& replayed) {
  const ReplaySummary summary = summary_of(replayed.answers);
  if (summary.is_primed) {
    std::cout << "work: " << summary.priming << " to prime; a period " << fixed(summary.mean, 1)
              << " on average, " << summary.percentile_999 << " at the 99.9th percentile, at most "
              << summary.most << "\n";
  }
}

void print_motion(const Replayed& replayed, std::size_t i) {
  const CertifiedMotion& motion = replayed.motions[i];
  std::cout << "  to line " << replayed.trajectory.line(i + 1) << ": ";
  if (motion.answer.status != Status::done) {
    std::cout << "refused\n";
    return;
  }
  std::cout << links_of(replayed.robot, motion.answer.pair)
            << (motion.answer.outcome == MotionOutcome::hit ? " hit " : " close ")
            << significant(motion.part, 4) << " of the way on, at ";
  for (std::size_t v = 0; v < motion.values.size(); ++v) {
    std::cout << (v == 0 ? "" : ", ") << variable_name(replayed.robot, v) << " "
              << significant(motion.values[v], 6);
  }
  std::cout << "\n";
}

bool is_free(const CertifiedMotion& motion) {
  return motion.answer.status == Status::done && motion.answer.outcome == MotionOutcome::free;
}

void print_motions(const Replayed& replayed) {
  const auto& motions = replayed.motions;
  const auto free = std::count_if(motions.begin(), motions.end(), is_free);
  const std::size_t others = motions.size() - static_cast<std::size_t>(free);
  std::cout << "\nmotions from line to line: " << free << " free, " << others << " not\n";
  std::size_t shown = 0;
  for (std::size_t i = 0; i < motions.size() && shown < kShownLines; ++i) {
    if (!is_free(motions[i])) {
      print_motion(replayed, i);
      ++shown;
    }
  }
  if (shown < others) {
    std::cout << "  and " << others - shown << " more: --json has all\n";
  }
}

void add_pair(const BakedRobot& robot, std::uint16_t pair, Json& json) {
  const bool is_none = pair == kNoPair;
  const RobotPair links = is_none ? RobotPair{} : robot.robot().pairs[pair];
  json["a"] = is_none ? Json() : Json(link_name(robot, links.a));
  json["b"] = is_none ? Json() : Json(link_name(robot, links.b));
}

Json motion_json(const BakedRobot& robot, const CertifiedMotion& motion) {
  const MotionAnswer& answer = motion.answer;
  if (answer.status != Status::done) {
    return {{"outcome", "refused"}};
  }
  Json json = {{"outcome", outcome_name(answer.outcome)}};
  if (answer.outcome == MotionOutcome::free) {
    return json;
  }
  json["part"] = motion.part;
  add_pair(robot, answer.pair, json);
  if (answer.outcome == MotionOutcome::hit) {
    json["triangles"] = {answer.triangles.a, answer.triangles.b};
  }
  for (std::size_t i = 0; i < motion.values.size(); ++i) {
    json["values"][variable_name(robot, i)] = motion.values[i];
  }
  return json;
}

Json period_json(const Replayed& replayed, std::size_t i) {
  const GuardAnswer& answer = replayed.answers[i];
  Json json = {{"line", replayed.trajectory.line(i)}, {"verdict", name_of(answer.verdict)}};
  add_pair(replayed.robot, answer.pair, json);
  json["distance"] =
      answer.pair == kNoPair ? Json() : Json(unit_length(answer.distance, replayed.robot.cell));
  json["work"] = answer.work;
  json["status"] = name_of(answer.status);
  if (i != 0 && replayed.has_motions) {
    json["motion"] = motion_json(replayed.robot, replayed.motions[i - 1]);
  }
  return json;
}

}  // namespace

void print_replayed(const Replayed& replayed) {
  const std::uint16_t pairs = replayed.robot.robot().pair_count;
  std::cout << replayed.answers.size()
            << (replayed.answers.size() == 1 ? " period, " : " periods, ") << pairs
            << (pairs == 1 ? " pair" : " pairs") << " of links guarded\n\n";
  print_counts(replayed);
  print_closest(replayed);
  print_work(replayed);
  if (replayed.has_motions) {
    print_motions(replayed);
  }
}

void print_replayed_json(const Replayed& replayed) {
  for (std::size_t i = 0; i < replayed.answers.size(); ++i) {
    std::cout << period_json(replayed, i).dump(-1, ' ', false, Json::error_handler_t::replace)
              << "\n";
  }
}

void print_refused(const Replayed& replayed) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < replayed.answers.size(); ++i) {
    if (replayed.answers[i].status != Status::done && ++refused <= kShownLines) {
      std::cerr << "flashbvh: "
                << one_line(at_line(replayed.path, replayed.trajectory.line(i)) + ": " +
                            why_refused(replayed, i))
                << "\n";
    }
  }
  if (refused > kShownLines) {
    std::cerr << "flashbvh: " << one_line(replayed.path) << ": and " << refused - kShownLines
              << " more lines with values that are refused\n";
  }
}

ExitCode exit_code_of(const Replayed& replayed) {
  const auto& answers = replayed.answers;
  if (std::any_of(answers.begin(), answers.end(),
                  [](const GuardAnswer& answer) { return answer.status != Status::done; })) {
    return kRefusedValues;
  }
  const bool is_free_all =
      std::all_of(answers.begin(), answers.end(),
                  [](const GuardAnswer& answer) { return answer.verdict <= Verdict::warn; }) &&
      std::all_of(replayed.motions.begin(), replayed.motions.end(), is_free);
  return is_free_all ? kSuccess : kCheckFailed;
}

}  // namespace flashbvh::tool
