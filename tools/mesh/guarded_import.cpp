// POSIX; that memory is limited takes Linux's /proc. A platform without processes replaces this
// file by one that calls the reader.
#include "mesh/guarded_import.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <type_traits>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kFix = "; export the mesh again, or as STL or PLY";

// The first byte of a result; the mesh or the message follows.
constexpr char kMesh = 'm';
constexpr char kRefusal = 'r';

std::string result_of(const std::function<FileMesh()>& read, const std::string& file) {
  try {
    return kMesh + bytes_of(read());
  } catch (const UserError& error) {
    return kRefusal + std::string(error.what());
  } catch (const std::exception& error) {
    return kRefusal + concat(file, ": can't be read: ", one_line(error.what()), kFix);
  }
}

/// Of the child. A crash ends it at once, without a core; so does the end of its parent.
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

/// The child's whole life: the parent's buffered output and exit handlers are not its own.
[[noreturn]] void read_and_send(const std::function<FileMesh()>& read, const std::string& file,
                                std::uint64_t cpu_seconds, int to) {
  set_limits(cpu_seconds);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const std::string result = result_of(read, file);
  std::string_view rest = result;
  while (!rest.empty()) {
    const ssize_t written = write(to, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      _exit(1);
    }
    rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  _exit(0);
}

/// 0 where that cannot be known.
std::uint64_t resident_bytes(pid_t process) {
  std::ifstream statm(concat("/proc/", process, "/statm"));
  std::uint64_t all = 0;
  std::uint64_t resident = 0;
  statm >> all >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// The reader's process, seen from its parent.
class Child {
 public:
  Child(const std::function<FileMesh()>& read, const std::string& file, const ImportLimits& limits)
      : file_(file), limits_(limits), shared_bytes_(resident_bytes(getpid())) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
      refuse("no process can be started: ", std::strerror(errno));
    }
    process_ = fork();
    if (process_ == 0) {
      close(ends[0]);
      read_and_send(read, file, limits.cpu_seconds, ends[1]);
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

  /// What it sent before it ended. UserError unless it ended well.
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

  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, "can't be read: ", what..., kFix);
  }

 private:
  static constexpr int kMilliseconds = 10;  ///< between two looks at the memory

  /// Appends what came within a while, if anything. False at the end.
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
  const ImportLimits limits_;
  const std::uint64_t shared_bytes_;  ///< the parent's, which the child has, too, from the start
  int from_ = -1;
  pid_t process_ = -1;
};

template <class Value>
void append(std::string& bytes, const Value* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::uint64_t size = count;
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

void append(std::string& bytes, const std::vector<std::string>& texts) {
  const std::uint64_t count = texts.size();
  append(bytes, &count, 1);
  for (const std::string& text : texts) {
    append(bytes, text.data(), text.size());
  }
}

/// Takes what append() put there, front to back.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  /// A std::vector or std::string. False if the bytes do not hold it.
  template <class Container>
  bool take(Container& values) {
    using Value = typename Container::value_type;
    std::uint64_t count = 0;
    if (rest_.size() < sizeof count) {
      return false;
    }
    std::memcpy(&count, rest_.data(), sizeof count);
    rest_.remove_prefix(sizeof count);
    if (count > rest_.size() / sizeof(Value)) {
      return false;
    }
    values.resize(static_cast<std::size_t>(count));
    const std::size_t size = values.size() * sizeof(Value);
    if (size != 0) {
      std::memcpy(static_cast<void*>(values.data()), rest_.data(), size);
    }
    rest_.remove_prefix(size);
    return true;
  }

  bool take(std::vector<std::string>& texts) {
    std::vector<std::uint64_t> count;
    if (!take(count) || count.size() != 1 || count[0] > rest_.size() / sizeof count[0]) {
      return false;
    }
    texts.resize(static_cast<std::size_t>(count[0]));
    return std::all_of(texts.begin(), texts.end(),
                       [this](std::string& text) { return take(text); });
  }

  bool is_empty() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

bool is_sound(const FileMesh& mesh) {
  const auto below = [](std::size_t limit) {
    return [limit](std::uint32_t index) { return index < limit; };
  };
  const auto corners_exist = [&](const bake::TriangleCorners& triangle) {
    return std::all_of(triangle.begin(), triangle.end(), below(mesh.mesh.vertices.size()));
  };
  const auto is_point = [](const Position& point) {
    return std::all_of(point.begin(), point.end(), is_coordinate);
  };
  return !mesh.mesh.triangles.empty() && mesh.body_of.size() == mesh.mesh.triangles.size() &&
         std::isfinite(mesh.precision) &&
         std::all_of(mesh.mesh.vertices.begin(), mesh.mesh.vertices.end(), is_point) &&
         std::all_of(mesh.mesh.triangles.begin(), mesh.mesh.triangles.end(), corners_exist) &&
         std::all_of(mesh.body_of.begin(), mesh.body_of.end(), below(mesh.bodies.size()));
}

}  // namespace

FileMesh guarded_import(const std::function<FileMesh()>& read, const std::string& file,
                        const ImportLimits& limits) {
  Child child(read, file, limits);
  const std::string result = child.result();
  const std::string content = result.substr(1);
  const std::size_t colon = content.find(": ");
  if (result[0] == kRefusal && colon != std::string::npos) {
    throw UserError(content.substr(0, colon), content.substr(colon + 2));
  }
  std::optional<FileMesh> mesh = mesh_of_bytes(content);
  if (result[0] != kMesh || !mesh) {
    child.refuse("its reader gave no mesh");
  }
  return std::move(*mesh);
}

std::string bytes_of(const FileMesh& mesh) {
  std::string bytes;
  append(bytes, mesh.mesh.vertices.data(), mesh.mesh.vertices.size());
  append(bytes, mesh.mesh.triangles.data(), mesh.mesh.triangles.size());
  append(bytes, mesh.bodies);
  append(bytes, mesh.body_of.data(), mesh.body_of.size());
  append(bytes, &mesh.precision, 1);
  append(bytes, mesh.warnings);
  return bytes;
}

std::optional<FileMesh> mesh_of_bytes(std::string_view bytes) {
  Unpacker unpacker(bytes);
  FileMesh mesh;
  std::vector<double> precision;
  const bool is_whole = unpacker.take(mesh.mesh.vertices) && unpacker.take(mesh.mesh.triangles) &&
                        unpacker.take(mesh.bodies) && unpacker.take(mesh.body_of) &&
                        unpacker.take(precision) && precision.size() == 1 &&
                        unpacker.take(mesh.warnings) && unpacker.is_empty();
  if (!is_whole) {
    return std::nullopt;
  }
  mesh.precision = precision[0];
  return is_sound(mesh) ? std::optional<FileMesh>(std::move(mesh)) : std::nullopt;
}

}  // namespace flashbvh::tool
