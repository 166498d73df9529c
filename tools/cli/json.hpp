// The JSON output of all commands: fields in order, one object per line.
#pragma once

#include <iostream>
#include <nlohmann/json.hpp>
#include <vector>

#include "flashbvh/contact.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

using Json = nlohmann::ordered_json;

/// Prints a line on standard output; replaces bytes that are not valid UTF-8.
inline void print_object(const Json& object) {
  std::cout << object.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

inline Json json_of(const Warnings& warnings) {
  Json all = Json::array();
  for (const PlacedWarning& warning : warnings.all()) {
    all.push_back({{"place", warning.place}, {"warning", warning.what}});
  }
  return all;
}

/// Converts a length in 1/256 cell to the unit of the cell.
inline double unit_length(std::int64_t fine, double cell) {
  return static_cast<double>(fine) * cell / kFineOne;
}

inline Json point_json(const FinePoint& point, double cell) {
  return {unit_length(point.x, cell), unit_length(point.y, cell), unit_length(point.z, cell)};
}

inline Json unguarded_json(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  auto json = Json::array();
  for (const UnguardedPair& pair : unguarded) {
    json.push_back({{"a", model.links[pair.a].name},
                    {"b", model.links[pair.b].name},
                    {"reason", reason_of(model, pair)}});
    if (pair.why == WhyUnguarded::zone) {
      json.back()["joint"] = model.joints[pair.joint].name;
      json.back()["radius"] = pair.radius;
    }
  }
  return json;
}

}  // namespace flashbvh::tool
