// Pairs that are not guarded, as JSON.
#ifndef FLASHBVH_TOOLS_CLI_UNGUARDED_JSON_HPP
#define FLASHBVH_TOOLS_CLI_UNGUARDED_JSON_HPP

#include <vector>

#include "robot/matrix/unguarded.hpp"

namespace flashbvh::tool {

inline Json unguarded_json(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  auto json = Json::array();
  for (const UnguardedPair& pair : unguarded) {
    json.push_back({{"a", model.links[pair.a].name},
                    {"b", model.links[pair.b].name},
                    {"reason", pair.reason}});
  }
  return json;
}

}  // namespace flashbvh::tool

#endif
