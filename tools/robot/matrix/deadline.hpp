// Until when something is to be done.
#pragma once

#include <chrono>
#include <optional>

namespace flashbvh::tool {

using Clock = std::chrono::steady_clock;

/// None: there is no hurry, and results depend on nothing but the robot.
struct Deadline {
  std::optional<Clock::time_point> at;

  bool is_past() const { return at && Clock::now() >= *at; }
};

inline Deadline in_seconds(Clock::time_point began, double seconds) {
  return {began +
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))};
}

}  // namespace flashbvh::tool
