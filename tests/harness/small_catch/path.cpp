#include "path.hpp"

#include <stdint.h>

#include "assertion.hpp"

namespace small_catch {
namespace {

struct Level {
  uint8_t next;  ///< the number, in order, of what this run enters
  uint8_t seen;  ///< how many it has come by
  bool has_more;
};

constexpr unsigned kMostLevels = 8;
Level levels[kMostLevels];
unsigned depth = 0;

[[noreturn]] void misuse(const char* text) {
  port::print("small_catch: ", text, "\n");
  stop();
}

Level& level_here() {
  if (depth == kMostLevels) {
    misuse("sections are nested too deeply");
  }
  return levels[depth];
}

bool enter() {
  Level& level = level_here();
  const uint8_t number = level.seen++;
  if (number != level.next) {
    level.has_more = level.has_more || number > level.next;
    return false;
  }
  ++depth;
  return true;
}

void start_run() {
  depth = 0;
  for (Level& level : levels) {
    level.seen = 0;
    level.has_more = false;
  }
}

}  // namespace

void first_path() {
  start_run();
  for (Level& level : levels) {
    level.next = 0;
  }
}

bool next_path() {
  for (unsigned i = kMostLevels; i != 0; --i) {
    Level& level = levels[i - 1];
    if (level.has_more) {
      ++level.next;
      start_run();
      return true;
    }
    level.next = 0;
  }
  return false;
}

Section::Section(const char* name) : depth_(depth), entered_(enter()), info_(name) {}

Section::~Section() {
  depth = depth_;
}

size_t choose(size_t count) {
  Level& level = level_here();
  if (level.seen != 0) {
    misuse("GENERATE after a SECTION");
  }
  level.has_more = level.next + 1u < count;
  ++depth;
  return level.next;
}

}  // namespace small_catch
