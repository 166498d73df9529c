// A progress bar on standard error while a command works.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace flashbvh::tool {

/// Shows nothing during the first second, or if standard error is not a terminal. Clears the line
/// at the end.
class Progress {
 public:
  /// `total`: sum of all steps' weights.
  explicit Progress(double total);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// Ends the last step and begins the next one.
  void begin(const std::string& step, double weight);

 private:
  using Clock = std::chrono::steady_clock;
  void draw_after_a_while();
  void draw();

  const double total_;
  const Clock::time_point began_ = Clock::now();
  bool has_no_thread_ = false;
  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopped_ = false;
  bool drawn_ = false;
  double done_ = 0;
  double weight_ = 0;
  std::string step_;
  std::thread thread_;
};

}  // namespace flashbvh::tool
