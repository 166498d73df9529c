// The JSON of flashbvh guard.
#include <algorithm>
#include <iterator>

#include "cli/commands.hpp"
#include "cli/robot/guard_output.hpp"
#include "cli/table.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kVerdictNames[kPeriodKinds] = {"free",          "warn", "leaving",
                                                     "not_yet_known", "stop", "refused"};

void add_pair(const GuardedTrajectory& guarded, std::uint16_t pair, Json& json) {
  const bool is_none = pair == kNoPair;
  const RobotPair links = is_none ? RobotPair{} : guarded.robot().pairs[pair];
  json["a"] = is_none ? Json() : Json(guarded.model.links[links.a].name);
  json["b"] = is_none ? Json() : Json(guarded.model.links[links.b].name);
}

constexpr std::array<const char*, 5> kLimitNames = {"granted", "shortened", "held", "not_yet_known",
                                                    "refused"};

std::size_t limit_kind(const LimitAnswer& answer) {
  return static_cast<std::size_t>(answer.verdict);
}

Json metres_json(const GuardedTrajectory& guarded, std::optional<std::uint32_t> fine) {
  return fine ? Json(unit_length(*fine, cell_of(guarded.robot()))) : Json();
}

Json limit_json(const GuardedTrajectory& guarded, const LimitAnswer& answer) {
  Json json = {{"verdict", kLimitNames[limit_kind(answer)]}, {"share", answer.share / 4096.0}};
  if (answer.pair != kNoPair) {
    add_pair(guarded, answer.pair, json);
    json["floor"] = metres_json(guarded, answer.floor);
    json["distance"] = metres_json(guarded, answer.distance);
  }
  return json;
}

Json motion_json(const GuardedTrajectory& guarded, const CertifiedMotion& motion) {
  const MotionAnswer& answer = motion.answer;
  if (answer.status != Status::done) {
    return {{"outcome", "refused"}};
  }
  Json json = {{"outcome", outcome_name(answer.outcome)}};
  if (answer.outcome == MotionOutcome::free) {
    return json;
  }
  json["part"] = motion.part;
  add_pair(guarded, answer.pair, json);
  if (answer.outcome == MotionOutcome::hit) {
    json["triangles"] = {answer.triangles.a, answer.triangles.b};
  }
  for (std::size_t i = 0; i < motion.values.size(); ++i) {
    json["values"][guarded.model.joints[guarded.model.variables[i]].name] = motion.values[i];
  }
  return json;
}

Json period_json(const GuardedTrajectory& guarded, std::size_t i) {
  const GuardAnswer& answer = guarded.answers[i];
  Json json = {{"line", guarded.trajectory.lines[i]}};
  if (!guarded.trajectory.times.empty()) {
    json["time"] = guarded.trajectory.times[i];
  }
  json["verdict"] = kVerdictNames[kind_of(answer)];
  add_pair(guarded, answer.pair, json);
  json["distance"] = answer.pair == kNoPair ? Json() : metres_json(guarded, answer.distance);
  json["work"] = answer.work;
  json["status"] = answer.status == Status::done ? "ok" : status_name(answer.status);
  if (!guarded.limits.empty()) {
    json["limit"] = limit_json(guarded, guarded.limits[i]);
  }
  if (i != 0 && guarded.has_motions) {
    json["motion"] = motion_json(guarded, guarded.motions[i - 1]);
  }
  return json;
}

}  // namespace

std::string links_of(const GuardedTrajectory& guarded, std::uint16_t pair) {
  const RobotPair& links = guarded.robot().pairs[pair];
  return guarded.model.links[links.a].name + " - " + guarded.model.links[links.b].name;
}

std::string first_of(const GuardedTrajectory& guarded, const ReplaySummary& summary,
                     std::size_t kind) {
  const GuardAnswer& answer = guarded.answers[summary.first[kind]];
  const bool has_links = kind != kRefusedKind && answer.pair != kNoPair;
  return concat("first at line ", guarded.trajectory.lines[summary.first[kind]],
                has_links ? ", " + links_of(guarded, answer.pair) : "");
}

Json stretches_json(const GuardedTrajectory& guarded, const std::vector<Stretch>& stretches) {
  Json all = Json::array();
  for (const Stretch& stretch : stretches) {
    Json json = {{"from", guarded.trajectory.lines[stretch.first]},
                 {"to", guarded.trajectory.lines[stretch.last]}};
    if (!guarded.trajectory.times.empty()) {
      json["from_time"] = guarded.trajectory.times[stretch.first];
      json["to_time"] = guarded.trajectory.times[stretch.last];
    }
    json["verdict"] = kVerdictNames[stretch.kind];
    add_pair(guarded, stretch.pair, json);
    json["distance"] = stretch.pair == kNoPair ? Json() : metres_json(guarded, stretch.kept);
    json["closest"] = metres_json(guarded, stretch.closest);
    all.push_back(json);
  }
  return all;
}

Json motions_json(const GuardedTrajectory& guarded) {
  Json all = Json::array();
  for (std::size_t i = 0; i < guarded.motions.size(); ++i) {
    if (!is_free(guarded.motions[i])) {
      all.push_back(
          {{"from", guarded.trajectory.lines[i]}, {"to", guarded.trajectory.lines[i + 1]}});
      all.back().update(motion_json(guarded, guarded.motions[i]));
    }
  }
  return all;
}

Json limits_json(const GuardedTrajectory& guarded) {
  Json all = Json::array();
  for (std::size_t kind = 0; kind < kLimitNames.size(); ++kind) {
    const auto is_of_kind = [&](const LimitAnswer& answer) { return limit_kind(answer) == kind; };
    const auto& limits = guarded.limits;
    const auto first = std::find_if(limits.begin(), limits.end(), is_of_kind);
    Json row = {{"verdict", kLimitNames[kind]},
                {"periods", std::count_if(limits.begin(), limits.end(), is_of_kind)},
                {"line", nullptr}};
    if (kind != 0 && first != limits.end()) {
      row["line"] = guarded.trajectory.lines[static_cast<std::size_t>(first - limits.begin())];
      add_pair(guarded, first->pair, row);
      row["touches"] = first->verdict == LimitVerdict::held && first->floor == 0;
    }
    all.push_back(row);
  }
  return all;
}

std::string trajectory_csv(const GuardedTrajectory& guarded) {
  const Trajectory& trajectory = guarded.trajectory;
  const bool has_times = !trajectory.times.empty();
  std::string text = has_times ? trajectory.time_name + "," : "";
  text += joined(
      guarded.model.variables, [&](std::size_t joint) { return guarded.model.joints[joint].name; },
      ",");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const float* const values = trajectory.values(i);
    const std::vector<double> row(values, values + trajectory.variables);
    text += "\n" + (has_times ? shortest(trajectory.times[i]) + "," : "") +
            joined(
                row, [](double value) { return significant(value, 9); }, ",");
  }
  return text + "\n";
}

Json guarded_facts(const GuardedTrajectory& guarded) {
  Json json = {
      {"periods", Json::object()},
      {"not_guarded", unguarded_json(guarded.model, guarded.file->unguarded())},
      {"stretches",
       stretches_json(guarded, stretches_of(guarded.robot(), guarded.trajectory, guarded.answers))},
      {"deviation", links_deviation(guarded.robot())}};
  const ReplaySummary summary = summary_of(guarded.answers);
  for (const std::size_t kind : kKindsInOrder) {
    json["periods"][kVerdictNames[kind]] = summary.periods[kind];
  }
  if (!guarded.limits.empty()) {
    json["limits"] = limits_json(guarded);
  }
  const Json motions = motions_json(guarded);
  if (!motions.empty()) {
    json["motions"] = motions;
  }
  return json;
}

void print_guarded_json(const GuardedTrajectory& guarded) {
  for (std::size_t i = 0; i < guarded.answers.size(); ++i) {
    Json json = period_json(guarded, i);
    if (i == 0) {
      json.update(guarded_facts(guarded));
      if (!guarded.cost.is_null()) {
        json["cost"] = guarded.cost;
      }
    }
    print_object(json);
  }
}

}  // namespace flashbvh::tool
