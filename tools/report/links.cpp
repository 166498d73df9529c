#include "report/links.hpp"

#include <map>

#include "report/html.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

std::string links_of(const Model& model, std::size_t a, std::size_t b) {
  return escaped(model.links[a].name) + " - " + escaped(model.links[b].name);
}

std::string joint_values(const Model& model, const std::vector<double>& values) {
  return joined(model.variables, [&](std::size_t joint) {
    const ModelJoint& of = model.joints[joint];
    return escaped(of.name) + " " + significant(values[of.variable], 6);
  });
}

std::string shown_values(const std::vector<double>& values) {
  return values.empty() ? ""
                        : " data-values=\"" +
                              joined(
                                  values, [](double value) { return significant(value, 9); }, " ") +
                              "\"";
}

std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  std::map<WhyUnguarded, std::vector<UnguardedPair>> by_reason;
  for (const UnguardedPair& pair : unguarded) {
    by_reason[pair.why].push_back(pair);
  }
  std::string html;
  for (const auto& [why, pairs] : by_reason) {
    html += decision(
        "v1", "Not guarded",
        escaped(names_of(model, pairs) + (why == WhyUnguarded::believed
                                              ? " (" + reason_of(model, pairs.front()) + ")"
                                              : "")));
  }
  return html;
}

}  // namespace flashbvh::tool
