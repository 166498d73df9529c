// Runs work on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace flashbvh::tool {

/// The number of threads that run at once.
inline std::size_t processor_count() {
  return std::max<std::size_t>(1, std::thread::hardware_concurrency());
}

/// Calls `work` on all processors, with each number below `count`, in any order. If calls throw, no
/// new calls start; rethrows the exception of the lowest number after all running calls have
/// returned.
template <class Work>
void for_each_in_parallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t thrower = count;
  std::exception_ptr thrown;
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (i < thrower) {
          thrower = i;
          thrown = std::current_exception();
        }
        next = count;
      }
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < std::min(processor_count(), count); ++i) {
    threads.emplace_back(run);
  }
  run();
  for (std::thread& thread : threads) {
    thread.join();
  }
  if (thrown) {
    std::rethrow_exception(thrown);
  }
}

}  // namespace flashbvh::tool
