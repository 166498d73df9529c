// Until when something is to be done.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

namespace flashbvh::tool {

using Clock = std::chrono::steady_clock;

/// None: there is no hurry, and results depend on nothing but the robot.
struct Deadline {
  std::optional<Clock::time_point> at;
  /// Of tests, instead of a moment: so many times it is not past when it is looked at. What one
  /// thread does until then depends on nothing but the robot, either.
  std::shared_ptr<std::atomic<std::int64_t>> looks = nullptr;

  bool is_past() const {
    return looks != nullptr ? looks->fetch_sub(1) <= 0 : at && Clock::now() >= *at;
  }
};

inline Deadline after_looks(std::int64_t count) {
  return {std::nullopt, std::make_shared<std::atomic<std::int64_t>>(count)};
}

inline Deadline in_seconds(Clock::time_point began, double seconds) {
  return {began +
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))};
}

}  // namespace flashbvh::tool
