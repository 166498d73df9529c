// Pages: what a command prints as JSON, below a drawing that answers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/table.hpp"
#include "viewer/page.hpp"

namespace flashbvh::tool {

/// A guard's verdict, which colours a line of a page (0 free, 1 warn, 3 not yet known, 4 stop), and
/// its text.
using Headline = std::pair<int, std::string>;

/// A self-contained HTML file, the same bytes for the same facts. The first of `headlines` says
/// what to do. `facts`: an array of objects; `drawing`: as robot.js or scene.js takes it.
inline std::string page_text(const char* command, const std::string& title,
                             const std::vector<Headline>& headlines, const Json& facts,
                             const Json& drawing) {
  Json data = {{"command", command},
               {"title", title},
               {"headlines", headlines},
               {"facts", facts},
               {"version", version_text()}};
  data["drawing"] = *kPageLibrary != '\0' ? drawing : Json();
  return page_of(data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// Links that no guard looks at, a line each reason.
inline void add_unguarded(const Model& model, const std::vector<UnguardedPair>& unguarded,
                          std::vector<Headline>& lines) {
  for (const WhyUnguarded why : {WhyUnguarded::zone, WhyUnguarded::believed}) {
    std::vector<UnguardedPair> pairs;
    for (const UnguardedPair& pair : unguarded) {
      if (pair.why == why) {
        pairs.push_back(pair);
      }
    }
    if (!pairs.empty()) {
      lines.push_back({1, "Not guarded: " + names_of(model, pairs)});
    }
  }
}

}  // namespace flashbvh::tool
