// Needs POSIX, and Linux's /proc to limit memory. On a platform without processes, import_here.cpp
// replaces this file and guarded_import.cpp.
#include "mesh/guarded_child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// The child's limits. It ends at once, without a core dump, if it crashes or its parent ends.
void set_limits(std::uint64_t cpu_seconds) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit cpu = {cpu_seconds, cpu_seconds + 1};
  setrlimit(RLIMIT_CPU, &cpu);
  const rlimit core = {0, 0};
  setrlimit(RLIMIT_CORE, &core);
  for (const int ending : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGXCPU}) {
    signal(ending, SIG_DFL);
  }
}

/// Runs the child to its end, without the parent's buffered output and exit handlers.
[[noreturn]] void live(const std::function<void(int to)>& work, std::uint64_t cpu_seconds, int to) {
  set_limits(cpu_seconds);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  work(to);
  _exit(0);
}

/// 0 if unknown.
std::uint64_t resident_bytes(pid_t process) {
  std::ifstream statm(concat("/proc/", process, "/statm"));
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  statm >> all >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// The reader's process, as its parent handles it.
class Child {
 public:
  Child(const std::function<void(int to)>& work, const std::string& file,
        const ImportLimits& limits, const char* fix)
      : file_(file), fix_(fix), limits_(limits), shared_bytes_(resident_bytes(getpid())) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
      refuse("no process can be started: ", std::strerror(errno));
    }
    process_ = fork();
    if (process_ == 0) {
      close(ends[0]);
      live(work, limits.cpu_seconds, ends[1]);
    }
    close(ends[1]);
    from_ = ends[0];
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    close(from_);
  }

  /// The bytes that the child sends. UserError unless it ends with exit code 0.
  std::string result() {
    if (process_ < 0) {
      refuse("no process can be started");
    }
    std::string bytes;
    while (receive(bytes)) {
      const std::uint64_t resident = resident_bytes(process_);
      if (bytes.size() > limits_.bytes || resident > limits_.bytes + shared_bytes_) {
        refuse("takes over ", limits_.bytes >> 20, " MiB of memory");
      }
    }
    const int status = wait_for_end();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
      refuse("takes over ", limits_.cpu_seconds, " s of processor time");
    }
    if (WIFSIGNALED(status)) {
      refuse("its reader crashed (signal ", WTERMSIG(status), ")");
    }
    if (WEXITSTATUS(status) != 0 || bytes.empty()) {
      refuse("its reader crashed (exit code ", WEXITSTATUS(status), ")");
    }
    return bytes;
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, "can't be read: ", what..., fix_);
  }

  static constexpr int kMilliseconds = 10;  ///< between two checks of memory

  /// Appends bytes that arrive within kMilliseconds, if any. False at the end.
  bool receive(std::string& bytes) const {
    pollfd waited = {from_, POLLIN, 0};
    if (poll(&waited, 1, kMilliseconds) <= 0) {
      return true;
    }
    std::array<char, 0x10000> part{};
    const ssize_t size = read(from_, part.data(), part.size());
    bytes.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return size > 0 || (size < 0 && errno == EINTR);
  }

  int wait_for_end() {
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

  const std::string file_;
  const char* const fix_;
  const ImportLimits limits_;
  const std::uint64_t shared_bytes_;  ///< the parent's, which the child shares at its start
  int from_ = -1;
  pid_t process_ = -1;
};

}  // namespace

std::string guarded_bytes(const std::function<void(int to)>& work, const std::string& file,
                          const ImportLimits& limits, const char* fix) {
  return Child(work, file, limits, fix).result();
}

void send(std::string_view bytes, int to) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      _exit(1);
    }
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
}

}  // namespace flashbvh::tool
