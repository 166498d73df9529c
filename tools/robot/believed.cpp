#include "robot/believed.hpp"

#include <algorithm>
#include <set>

#include "robot/kinematics.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string pair_name(const Model& model, const PairVerdict& pair, const char* between) {
  return model.links[pair.a].name + between + model.links[pair.b].name;
}

/// "elbow 1.2, wrist 0": of the joints between the two links.
std::string values_of(const Model& model, const PairVerdict& pair) {
  const JointsBetween joints = joints_between(model, pair.a, pair.b);
  std::set<std::size_t> variables;
  for (const auto& branch : {joints.of_a, joints.of_b}) {
    for (const std::size_t joint : branch) {
      variables.insert(model.joints[joint].variable);
    }
  }
  std::string text;
  for (const std::size_t variable : variables) {
    text += concat(text.empty() ? "" : ", ", model.joints[model.variables[variable]].name, " ",
                   significant(pair.witness[variable], 5));
  }
  return text;
}

template <class Element>
bool is_of(const Element& element, std::size_t a, std::size_t b) {
  return std::minmax(element.a, element.b) == std::minmax(a, b);
}

}  // namespace

void believe(std::size_t a, std::size_t b, const std::string& place, Model& model) {
  const auto found = std::find_if(model.disabled.begin(), model.disabled.end(),
                                  [&](const DisabledPair& pair) { return is_of(pair, a, b); });
  if (found == model.disabled.end()) {
    throw UserError(place,
                    "names a pair that no SRDF disables; leave it out, or give the SRDF that "
                    "does by --srdf");
  }
  found->is_believed = true;
}

void check_disabled(const Model& model, const std::vector<PairVerdict>& pairs,
                    const std::string& srdf, Warnings& warnings) {
  std::string place;
  std::string first;
  std::string more;
  for (const DisabledPair& disabled : model.disabled) {
    const PairVerdict& pair = *std::find_if(
        pairs.begin(), pairs.end(),
        [&](const PairVerdict& decided) { return is_of(decided, disabled.a, disabled.b); });
    if (pair.verdict == MatrixVerdict::undecided) {
      warnings.add(at_line(srdf, disabled.line),
                   concat("disables ", pair_name(model, pair, " - "), ", which is ", pair.reason,
                          "; --believe ", pair_name(model, pair, ","), " leaves it out"));
    }
    if (disabled.is_believed && pair.verdict != MatrixVerdict::believed) {
      warnings.add(
          at_line(srdf, disabled.line),
          concat(pair_name(model, pair, " - "), " is ", name_of(pair.verdict),
                 ", with or without --believe ", pair_name(model, pair, ","), "; leave that out"));
    }
    if (pair.verdict != MatrixVerdict::can) {
      continue;
    }
    if (first.empty()) {
      place = at_line(srdf, disabled.line);
      first =
          concat("disables ", pair_name(model, pair, " - "),
                 disabled.reason.empty() ? "" : concat(" as \"", disabled.reason, "\""),
                 ", but they intersect at ", values_of(model, pair),
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

}  // namespace flashbvh::tool
