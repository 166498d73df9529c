// Until when something is to be done.
#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "text/parallel.hpp"

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

/// When one of `left` pieces of work has had its part of the time, `share` times an equal one.
inline Deadline turn_of(const Deadline& all, std::size_t left, double share) {
  if (!all.at) {
    return {};
  }
  const Clock::time_point now = Clock::now();
  const double part = share * static_cast<double>(processor_count()) /
                      static_cast<double>(std::max<std::size_t>(left, 1));
  const auto turn = std::chrono::duration<double>(*all.at - now) * std::min(1.0, part);
  return {now + std::chrono::duration_cast<Clock::duration>(turn)};
}

}  // namespace flashbvh::tool
