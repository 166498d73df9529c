#include "robot/matrix/unguarded.hpp"

#include <algorithm>
#include <set>

#include "flashbvh/clearance.hpp"
#include "image/fine_length.hpp"
#include "robot/kinematics.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string pair_name(const Model& model, const PairVerdict& pair, const char* between) {
  return model.links[pair.a].name + between + model.links[pair.b].name;
}

struct Why {
  WhyUnguarded why;
  const char* meaning;
  const char* advice;
};

constexpr Why kWhys[] = {
    {WhyUnguarded::zone, "neighbours touch about their joint",
     "what may collide outside is guarded; another zone by --zone JOINT=LENGTH"},
    {WhyUnguarded::believed, "disabled in the SRDF and believed, though they may collide",
     "to guard a pair, delete its line in the SRDF and its --believe"},
};

const Why& of(WhyUnguarded why) {
  return kWhys[static_cast<std::size_t>(why)];
}

std::string name_of(const Model& model, const UnguardedPair& pair) {
  return concat(model.links[pair.a].name, " - ", model.links[pair.b].name,
                pair.why == WhyUnguarded::zone
                    ? concat(" within ", radius_text(model, pair.radius, pair.joint),
                             pair.is_never_outside ? " (never outside zone)" : "")
                    : "");
}

}  // namespace

std::string witness_text(const Model& model, const PairVerdict& pair) {
  const JointsBetween joints = joints_between(model, pair.a, pair.b);
  std::set<std::size_t> variables;
  for (const auto& branch : {joints.of_a, joints.of_b}) {
    for (const std::size_t joint : branch) {
      variables.insert(model.joints[joint].variable);
    }
  }
  return joined(variables, [&](std::size_t variable) {
    return model.joints[model.variables[variable]].name + " " +
           significant(pair.witness[variable], 5);
  });
}

void believe(std::size_t a, std::size_t b, const std::string& place, Model& model) {
  DisabledPair* const found = find_pair(model.disabled, a, b);
  if (found == nullptr) {
    throw UserError(place,
                    "names a pair that no SRDF disables; leave it out, or give the SRDF that does");
  }
  found->is_believed = true;
}

void check_disabled(const Model& model, const std::vector<PairVerdict>& pairs,
                    const std::string& srdf, Warnings& warnings) {
  std::string place;
  std::string first;
  std::string more;
  for (const DisabledPair& disabled : model.disabled) {
    const PairVerdict& pair = *find_pair(pairs, disabled.a, disabled.b);
    if (pair.verdict == MatrixVerdict::undecided) {
      warnings.add(at_line(srdf, disabled.line),
                   concat("disables ", pair_name(model, pair, " - "), ", which is ", pair.reason,
                          "; --believe ", pair_name(model, pair, ","), " leaves it out"));
    }
    if (disabled.is_believed && pair.verdict != MatrixVerdict::believed) {
      warnings.add(
          at_line(srdf, disabled.line),
          concat(pair_name(model, pair, " - "), " is ", name_of(pair.verdict),
                 pair.zone ? " outside their joint's zone" : "", ", with or without --believe ",
                 pair_name(model, pair, ","), "; leave that out"));
    }
    if (pair.verdict != MatrixVerdict::can || pair.zone) {
      continue;
    }
    if (first.empty()) {
      place = at_line(srdf, disabled.line);
      first =
          concat("disables ", pair_name(model, pair, " - "),
                 disabled.reason.empty() ? "" : concat(" as \"", disabled.reason, "\""),
                 ", but they intersect at ", witness_text(model, pair),
                 "; delete the line, or stand by it with --believe ", pair_name(model, pair, ","));
    } else {
      more += concat(more.empty() ? ". So can: " : ", ", pair_name(model, pair, " - "), " (line ",
                     disabled.line, ")");
    }
  }
  if (!first.empty()) {
    throw UserError(place, first, more);
  }
}

std::string reason_of(const Model& model, const UnguardedPair& pair) {
  return pair.why == WhyUnguarded::zone
             ? concat("touch within ", radius_text(model, pair.radius, pair.joint),
                      pair.is_never_outside ? ", never outside zone" : "")
             : of(pair.why).meaning;
}

std::vector<UnguardedPair> unguarded_pairs(const std::vector<PairVerdict>& pairs,
                                           const std::vector<JointZone>& zones) {
  std::vector<UnguardedPair> unguarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.verdict == MatrixVerdict::believed) {
      unguarded.push_back({pair.a, pair.b, WhyUnguarded::believed});
    } else if (pair.zone) {
      const JointZone& zone = zones[*pair.zone];
      unguarded.push_back({pair.a, pair.b, WhyUnguarded::zone, zone.joint, zone.shape.radius,
                           pair.is_never_outside()});
    }
  }
  return unguarded;
}

RobotUnguarded fixed_unguarded(const UnguardedPair& pair, double cell) {
  return {static_cast<std::uint8_t>(pair.a), static_cast<std::uint8_t>(pair.b), pair.why,
          fixed_joint(pair.joint), fine_length_rounded_up(pair.radius, cell).count};
}

UnguardedPair unguarded_pair(const RobotUnguarded& fixed, double cell, bool is_never_outside) {
  const double radius = fixed.radius * cell / kFineOne;
  return {fixed.a, fixed.b, fixed.why, joint_of(fixed.joint), radius, is_never_outside};
}

std::string names_of(const Model& model, const std::vector<UnguardedPair>& pairs) {
  return joined(pairs, [&](const UnguardedPair& pair) { return name_of(model, pair); });
}

void warn_of_unguarded(const Model& model, const std::vector<UnguardedPair>& pairs,
                       const std::string& path, Warnings& warnings) {
  for (const Why& why : kWhys) {
    std::vector<UnguardedPair> named;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(named),
                 [&](const UnguardedPair& pair) { return pair.why == why.why; });
    if (!named.empty()) {
      warnings.add(path, concat("not guarded: ", names_of(model, named), " (", why.meaning,
                                "): a collision of these is never detected; ", why.advice));
    }
  }
}

}  // namespace flashbvh::tool
