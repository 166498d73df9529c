// JSON as all commands print it: fields in order, a line each.
#ifndef FLASHBVH_TOOLS_CLI_JSON_HPP
#define FLASHBVH_TOOLS_CLI_JSON_HPP

#include <nlohmann/json.hpp>
#include <string>

#include "text/messages.hpp"

namespace flashbvh::tool {

/// With its line end; bytes that are no UTF-8 are replaced.
inline std::string json_line(const nlohmann::ordered_json& object) {
  using Json = nlohmann::ordered_json;
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

inline nlohmann::ordered_json json_of(const Warnings& warnings) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const PlacedWarning& warning : warnings.all()) {
    all.push_back({{"place", warning.place}, {"warning", warning.what}});
  }
  return all;
}

}  // namespace flashbvh::tool

#endif
