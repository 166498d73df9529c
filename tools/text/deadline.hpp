// Deadlines by the clock, or by the number of checks.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>

#include "text/parallel.hpp"

namespace flashbvh::tool {

using Clock = std::chrono::steady_clock;

/// By default there is no deadline, and results depend on the robot alone.
struct Deadline {
  std::optional<Clock::time_point> at;
  /// In place of a time: the number of checks before the deadline is past. The results of a single
  /// thread then depend on the robot alone.
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

/// The deadline of one of `left` tasks: `share` times an equal part of the remaining time.
inline Deadline turn_of(const Deadline& all, std::size_t left, double share) {
  if (!all.at) {
    return all;
  }
  const Clock::time_point now = Clock::now();
  const double part = share * static_cast<double>(processor_count()) /
                      static_cast<double>(std::max<std::size_t>(left, 1));
  const auto turn = std::chrono::duration<double>(*all.at - now) * std::min(1.0, part);
  return {now + std::chrono::duration_cast<Clock::duration>(turn)};
}

}  // namespace flashbvh::tool
