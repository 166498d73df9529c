#include "cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::chrono::seconds kPatience(1);
constexpr std::size_t kBarWidth = 30;
constexpr std::size_t kStepWidth = 40;  ///< so that the whole line fits 80 columns

}  // namespace

Progress::~Progress() {
  if (drawn_) {
    std::fprintf(stderr, "\r%79s\r", "");
  }
}

void Progress::begin(const std::string& step, double weight) {
  const std::lock_guard<std::mutex> lock(mutex_);
  done_ += weight_;
  weight_ = weight;
  step_ = one_line(step);
  if (drawn_ || (Clock::now() - began_ > kPatience && isatty(STDERR_FILENO) != 0)) {
    draw();
  }
}

void Progress::draw() {
  const double part = total_ > 0 ? done_ / total_ : 0;
  std::string bar(kBarWidth, '-');
  bar.replace(0, static_cast<std::size_t>(part * kBarWidth),
              static_cast<std::size_t>(part * kBarWidth), '#');
  std::string step = step_.substr(0, kStepWidth);
  step.resize(kStepWidth, ' ');
  std::fprintf(stderr, "\r[%s] %3s %%  %s", bar.c_str(), fixed(100 * part, 0).c_str(),
               step.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace flashbvh::tool
