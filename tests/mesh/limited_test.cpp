// Readers under limits: whatever one does, the user gets a message.
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <stdexcept>

#include "mesh/any_format.hpp"
#include "mesh/limited_import.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

constexpr tool::ImportLimits kLimits = {32 << 20, 1};
const std::string kFix = "; export the mesh again, or as STL or PLY";

FileMesh one_triangle() {
  tool::MeshBuilder builder("file");
  builder.add_triangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  return builder.finish();
}

std::string said_of(const std::function<FileMesh()>& read) {
  return refusal([&](const std::string&,
                     const std::string& file) { return limited_import(read, file, kLimits); },
                 "");
}

/// The last words of a process that this reader ends with exit code 2.
std::string last_words(const std::function<FileMesh()>& read) {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  const pid_t process = fork();
  if (process == 0) {
    dup2(ends[1], STDERR_FILENO);
    limited_import(read, "file", kLimits);
    _exit(0);
  }
  close(ends[1]);
  std::string words(1000, '\0');
  words.resize(static_cast<std::size_t>(::read(ends[0], words.data(), words.size())));
  close(ends[0]);
  int status = 0;
  waitpid(process, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 2);
  return words;
}

/// Takes all of the stack; compilers can't know.
int depth_below(volatile int* above) {
  volatile int here = *above + 1;
  return here > 0 ? depth_below(&here) + here : 0;
}

}  // namespace

TEST_CASE("a limited reader's mesh and its refusal are passed on") {
  CHECK(limited_import(one_triangle, "file", kLimits).mesh.triangles.size() == 1);
  CHECK(said_of([]() -> FileMesh { throw tool::UserError("file", "is odd: why"); }) ==
        "file: is odd: why");
  CHECK(said_of([]() -> FileMesh { throw std::runtime_error("odd"); }) ==
        "file: can't be read: odd" + kFix);
}

TEST_CASE("a reader that crashes, even without a stack, ends the program with a message") {
  const std::string said = "flashbvh: file: can't be read: its reader crashed" + kFix + "\n";
  for (const int crash : {SIGABRT, SIGSEGV, SIGFPE}) {
    CHECK(last_words([&]() -> FileMesh {
            raise(crash);
            return one_triangle();
          }) == said);
  }
  CHECK(last_words([]() -> FileMesh {
          volatile int top = 0;
          return depth_below(&top) == 0 ? FileMesh() : one_triangle();
        }) == said);
}

TEST_CASE("a reader that never ends is ended, with a message") {
  CHECK(last_words([]() -> FileMesh {
          for (volatile int i = 0;; i = i ^ 1) {
          }
        }) == "flashbvh: file: can't be read: takes over 1 s" + kFix + "\n");
}

TEST_CASE("a reader that always grows is refused, and the program has its memory again") {
  const auto grow = [](std::size_t most) {
    std::vector<std::string> all;
    while (all.size() < most) {
      all.emplace_back(1 << 20, 'x');
    }
    return one_triangle();
  };
#if !defined(FLASHBVH_SANITIZE)  // which ends a program that runs out of memory
  CHECK(said_of([&] { return grow(SIZE_MAX); }) ==
        "file: can't be read: takes over 32 MiB of memory" + kFix);
#endif
  CHECK(grow(64).mesh.triangles.size() == 1);
}
