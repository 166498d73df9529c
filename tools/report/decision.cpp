#include "report/decision.hpp"

#include <algorithm>

#include "report/html.hpp"

namespace flashbvh::tool {

std::string decision(const std::string& style, const std::string& what, const std::string& of) {
  return "<li><i class=\"key " + style + "\"></i><b>" + what + "</b>" +
         (of.empty() ? "" : ": " + of) + "</li>\n";
}

std::string unguarded_decisions(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  std::string html;
  std::vector<UnguardedPair> left = unguarded;
  while (!left.empty()) {
    const WhyUnguarded why = left.front().why;
    const auto others = std::stable_partition(
        left.begin(), left.end(), [&](const UnguardedPair& pair) { return pair.why == why; });
    const std::vector<UnguardedPair> named(left.begin(), others);
    html += decision("v1", "Not guarded",
                     escaped(names_of(model, named) + " (" + named.front().reason + ")"));
    left.erase(left.begin(), others);
  }
  return html;
}

std::string decision_section(const std::string& title, const std::string& decisions) {
  return "<section id=decision><h2>" + title + "</h2>\n<ul class=verdict>\n" + decisions +
         "</ul></section>\n";
}

std::string decision_style() {
  // Lighter and darker than each other, too, for who can't tell them apart by colour.
  return ":root{--v0:#8a97a6;--v1:#c07f00;--v2:#6a45d6;--v3:#a8071a;--v4:#1c2128}\n"
         "@media (prefers-color-scheme:dark){"
         ":root{--v0:#66788c;--v1:#ffc53d;--v2:#a78bfa;--v3:#ff4d4f;--v4:#e6edf3}}\n"
         ".v0{background:var(--v0);fill:var(--v0)}.v1{background:var(--v1);fill:var(--v1)}\n"
         ".v2{background:var(--v2);fill:var(--v2)}.v3{background:var(--v3);fill:var(--v3)}\n"
         ".v4{background:var(--v4);fill:var(--v4)}\n"
         ".verdict li{overflow-wrap:anywhere}\n"
         "@media print{.key{print-color-adjust:exact;-webkit-print-color-adjust:exact}}\n";
}

}  // namespace flashbvh::tool
