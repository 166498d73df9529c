#include "cli/robot/guard_output.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "cli/json.hpp"
#include "robot/replay/replay.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr double kTurn = 6.283185307179586;
/// A value of a slide that is so many times its limits is taken for millimetres.
constexpr double kOtherUnit = 10;

bool slides(const ModelJoint& joint) {
  return joint.type == JointType::prismatic;
}

/// Whether the value is so far off that it may be in degrees, or in millimetres.
bool has_other_unit(const ModelJoint& joint, double value) {
  const double most = std::fmax(std::fabs(joint.lower), std::fabs(joint.upper));
  return std::fabs(value) > (slides(joint) ? kOtherUnit * most : kTurn);
}

/// "; in degrees? give radians: 1.5708".
std::string other_unit(const ModelJoint& joint, double value) {
  return slides(joint) ? "; in millimetres? give metres: " + significant(value / 1000, 6)
                       : "; in degrees? give radians: " + significant(value * kTurn / 360, 6);
}

/// "joint 'fold' can't be at 3.5", "joint 'other' can't follow 'grip' to 3.5".
std::string refused_place(const Replayed& replayed, const ModelJoint& joint, double value) {
  const std::string& master = variable_name(replayed.robot, joint.variable);
  return concat("joint '", joint.name,
                joint.name == master ? "' can't be at " : "' can't follow '" + master + "' to ",
                significant(value, 6), ": ");
}

/// Beyond what a coordinate can be.
std::string beyond_range(const Replayed& replayed, const ModelJoint& moved, double value) {
  if (!slides(moved)) {
    return "firmware takes less than 8 turns, 50.27 radians; leave full turns out" +
           other_unit(moved, value);
  }
  const double most = kMaxJointCoordinate * replayed.robot.cell / kFrameCell;
  return concat("firmware takes less than ", significant(most, 4), " m of this robot",
                other_unit(moved, value));
}

/// `moved`: the joint that the value is of, which `joint` may follow.
std::string beyond_limits(const ModelJoint& joint, const ModelJoint& moved, double value) {
  return concat(
      "its limits are ", significant(joint.lower, 6), " and ", significant(joint.upper, 6),
      has_other_unit(moved, value) ? (slides(moved) ? " m" : " radians") + other_unit(moved, value)
                                   : "; correct the value, or the URDF");
}

/// What is wrong with the values of a period, and how to fix it.
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
  const Model& model = replayed.robot.model;
  const ModelJoint& joint = model.joints[refused_joint(replayed.robot.robot(), values)];
  const ModelJoint& moved = model.joints[model.variables[joint.variable]];
  const auto value = static_cast<double>(values[joint.variable]);
  return refused_place(replayed, joint, value) + (status == Status::not_a_coordinate
                                                      ? beyond_range(replayed, moved, value)
                                                      : beyond_limits(joint, moved, value));
}

const char* verdict_name(const GuardAnswer& answer) {
  constexpr const char* kNames[kPeriodKinds] = {"free", "warn", "not_yet_known", "stop", "refused"};
  return kNames[kind_of(answer)];
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
  Json json = {{"line", replayed.trajectory.line(i)}, {"verdict", verdict_name(answer)}};
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

std::string links_of(const BakedRobot& robot, std::uint16_t pair) {
  const RobotPair& links = robot.robot().pairs[pair];
  return link_name(robot, links.a) + " - " + link_name(robot, links.b);
}

std::string metres_text(const Replayed& replayed, std::uint32_t fine) {
  return significant(unit_length(fine, replayed.robot.cell), 4);
}

/// "  first at line 3, upper - fore".
std::string first_of(const Replayed& replayed, std::size_t kind, std::size_t first) {
  const GuardAnswer& answer = replayed.answers[first];
  std::string text = concat("  first at line ", replayed.trajectory.line(first));
  if (kind == kRefusedKind || answer.pair == kNoPair) {
    return text;
  }
  text += ", " + links_of(replayed.robot, answer.pair);
  if (kind != static_cast<std::size_t>(Verdict::not_yet_known)) {
    return text;
  }
  return text + (answer.distance == 0
                     ? ", of which nothing is known"
                     : ", at least " + metres_text(replayed, answer.distance) + " m apart");
}

void print_counts(const Replayed& replayed) {
  const ReplaySummary counts = summary_of(replayed.answers);
  for (const std::size_t kind : kKindsInOrder) {
    std::cout << std::left << std::setw(15) << kKindNames[kind] << std::right << std::setw(9)
              << counts.periods[kind]
              << (kind == 0 || counts.periods[kind] == 0
                      ? ""
                      : first_of(replayed, kind, counts.first[kind]))
              << "\n";
  }
}

void print_stretch(const Replayed& replayed, const Stretch& stretch) {
  const bool is_refused = stretch.pair == kNoPair;
  std::cout << std::left << std::setw(9) << replayed.trajectory.line(stretch.first) << std::setw(9)
            << replayed.trajectory.line(stretch.last) << std::setw(15) << kKindNames[stretch.kind]
            << std::setw(12) << (is_refused ? "-" : metres_text(replayed, stretch.kept))
            << std::setw(12) << (stretch.closest ? metres_text(replayed, *stretch.closest) : "-")
            << (is_refused ? "-" : links_of(replayed.robot, stretch.pair)) << "\n";
}

/// What is not free.
void print_stretches(const Replayed& replayed) {
  const std::vector<Stretch> stretches =
      stretches_of(replayed.robot.robot(), replayed.trajectory, replayed.answers);
  if (stretches.empty()) {
    return;
  }
  std::cout << "\nfrom     to       verdict        known m     closest m   links\n";
  for (const Stretch& stretch : worst_of(stretches, kShownLines)) {
    print_stretch(replayed, stretch);
  }
  if (stretches.size() > kShownLines) {
    std::cout << "and " << stretches.size() - kShownLines << " more: --report has a table\n";
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

}  // namespace

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

void print_replayed_json(const Replayed& replayed) {
  for (std::size_t i = 0; i < replayed.answers.size(); ++i) {
    Json json = period_json(replayed, i);
    if (i == 0) {
      json["not_guarded"] = unguarded_json(replayed.robot.model, replayed.robot.unguarded);
    }
    print_object(json);
  }
}

void print_replayed(const Replayed& replayed) {
  const BakedRobot& robot = replayed.robot;
  const std::uint16_t pairs = robot.robot().pair_count;
  for (const UnguardedPair& pair : robot.unguarded) {
    std::cout << "not guarded: " << names_of(robot.model, {pair}) << " (" << pair.reason << ")\n";
  }
  std::cout << replayed.answers.size()
            << (replayed.answers.size() == 1 ? " period, " : " periods, ") << pairs
            << (pairs == 1 ? " pair" : " pairs") << " of links guarded, " << robot.unguarded.size()
            << " not looked at\n\n";
  print_counts(replayed);
  print_stretches(replayed);
  print_closest(replayed);
  print_work(replayed);
  if (replayed.has_motions) {
    print_motions(replayed);
  }
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

const std::string& variable_name(const BakedRobot& robot, std::size_t variable) {
  return robot.model.joints[robot.model.variables[variable]].name;
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
