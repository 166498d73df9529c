// A progress bar on standard error while a command works.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace flashbvh::tool {

/// Appears with the first step that begins after a second, if standard error is a terminal. Clears
/// the line at the end.
class Progress {
 public:
  /// `total`: sum of all steps' weights.
  explicit Progress(double total) : total_(total) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Ends the last step and begins the next one; from any thread.
  void begin(const std::string& step, double weight);

 private:
  using Clock = std::chrono::steady_clock;
  void draw();

  const double total_;
  const Clock::time_point began_ = Clock::now();
  std::mutex mutex_;
  bool drawn_ = false;
  double done_ = 0;
  double weight_ = 0;
  std::string step_;
};

}  // namespace flashbvh::tool
