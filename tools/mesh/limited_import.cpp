// Needs POSIX; memory is limited where Linux's /proc tells how much the program has.
#include "mesh/limited_import.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <fstream>
#include <new>
#include <vector>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

// Messages for end_with_message(), which may not make any.
std::string of_crash;
std::string of_timer;

extern "C" void end_with_message(int signal) {
  const std::string& message = signal == SIGPROF ? of_timer : of_crash;
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(2);
}

/// The memory that the program may write; 0 if unknown.
std::uint64_t bytes_of_program() {
  std::ifstream statm("/proc/self/statm");
  std::uint64_t pages = 0;
  for (int column = 0; column < 6 && statm; ++column) {
    statm >> pages;
  }
  return statm ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

/// Sends SIGPROF after seconds of computing, which do not depend on the machine's load; 0: never.
void set_timer(unsigned seconds) {
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  setitimer(ITIMER_PROF, &timer, nullptr);
}

/// Limits the program while it lives.
class Limits {
 public:
  explicit Limits(const ImportLimits& limits) {
#ifndef __EMSCRIPTEN__  // where no handler runs
    const stack_t own = {stack_.data(), 0, stack_.size()};
    sigaltstack(&own, &stack_before_);
#endif
    struct sigaction action = {};
    action.sa_handler = end_with_message;
    action.sa_flags = SA_ONSTACK;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], &action, &actions_before_[i]);
    }
    getrlimit(RLIMIT_DATA, &memory_before_);
    rlimit memory = memory_before_;
    if (const std::uint64_t now = bytes_of_program(); now != 0) {
      memory.rlim_cur = std::min<rlim_t>(now + limits.bytes, memory.rlim_max);
    }
    setrlimit(RLIMIT_DATA, &memory);
    set_timer(limits.seconds);
  }
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  ~Limits() {
    set_timer(0);
    setrlimit(RLIMIT_DATA, &memory_before_);
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], &actions_before_[i], nullptr);
    }
#ifndef __EMSCRIPTEN__
    sigaltstack(&stack_before_, nullptr);
#endif
  }

 private:
  static constexpr std::array<int, 6> kSignals = {SIGABRT, SIGPROF, SIGBUS,
                                                  SIGFPE,  SIGILL,  SIGSEGV};

  /// Lets a handler run although the reader has exhausted the program's stack.
  std::vector<char> stack_ = std::vector<char>(0x10000);
  [[maybe_unused]] stack_t stack_before_ = {};
  std::array<struct sigaction, kSignals.size()> actions_before_ = {};
  rlimit memory_before_ = {};
};

}  // namespace

FileMesh limited_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits& limits) {
  const auto said = [&](const std::string& what) {
    return one_line(concat("flashbvh: ", file, ": can't be read: ", what, kImportFix)) + "\n";
  };
  of_crash = said("its reader crashed");
  of_timer = said(concat("takes over ", limits.seconds, " s"));
  const Limits limited(limits);
  try {
    return read();
  } catch (const UserError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw UserError(file, "can't be read: takes over ", limits.bytes >> 20, " MiB of memory",
                    kImportFix);
  } catch (const std::exception& error) {
    throw UserError(file, "can't be read: ", one_line(error.what()), kImportFix);
  }
}

}  // namespace flashbvh::tool
