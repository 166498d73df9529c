// What the library tells in 1/256 cell, in the images' unit.
#ifndef FLASHBVH_TOOLS_CLI_LENGTHS_HPP
#define FLASHBVH_TOOLS_CLI_LENGTHS_HPP

#include <cstdint>
#include <nlohmann/json.hpp>

#include "flashbvh/contact.hpp"

namespace flashbvh::tool {

inline double unit_length(std::int64_t fine, double cell) {
  return static_cast<double>(fine) * cell / kFineOne;
}

inline nlohmann::ordered_json point_json(const FinePoint& point, double cell) {
  return {unit_length(point.x, cell), unit_length(point.y, cell), unit_length(point.z, cell)};
}

}  // namespace flashbvh::tool

#endif
