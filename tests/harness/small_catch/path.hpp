// SECTION and GENERATE: a test case runs once for each path through its sections, as in Catch2.
//
// A run enters one section of each level, the one that is next; sections that it passes behind it
// say that there is more. Then the deepest level that has more takes its next one, as the last
// wheel of a counter that can turn: every run takes the same way up to there.
#ifndef FLASHBVH_SMALL_CATCH_PATH_HPP
#define FLASHBVH_SMALL_CATCH_PATH_HPP

#include <stddef.h>

#include "message.hpp"

namespace small_catch {

/// Before a test case's first run.
void first_path();
/// After a run: whether there is another, which is then the next.
bool next_path();

/// True where the section is on this run's path.
class Section {
 public:
  explicit Section(const char* name);
  ~Section();
  Section(const Section&) = delete;
  Section& operator=(const Section&) = delete;

  explicit operator bool() const { return entered_; }

 private:
  const unsigned depth_;
  const bool entered_;
  Info info_;
};

/// One of 0 to count - 1: what follows in this scope runs for each.
size_t choose(size_t count);

template <class Value, class... Rest>
Value generate(Value first, Rest... rest) {
  const Value values[] = {first, static_cast<Value>(rest)...};
  return values[choose(sizeof values / sizeof values[0])];
}

}  // namespace small_catch

#endif
