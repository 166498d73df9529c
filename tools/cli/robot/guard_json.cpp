// What `flashbvh guard --json` prints.
#include <iostream>

#include "cli/json.hpp"
#include "cli/robot/guard_output.hpp"
#include "cli/unguarded_json.hpp"
#include "robot/replay/replay.hpp"

namespace flashbvh::tool {
namespace {

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

}  // namespace

void print_replayed_json(const Replayed& replayed) {
  for (std::size_t i = 0; i < replayed.answers.size(); ++i) {
    Json json = period_json(replayed, i);
    if (i == 0) {
      json["not_guarded"] = unguarded_json(replayed.robot.model, replayed.robot.unguarded);
    }
    print_object(json);
  }
}

}  // namespace flashbvh::tool
