// What calls of the library cost: runs the parts that FLASHBVH_PARTS names, and prints their
// figures. Exits with 1 if an answer is wrong.
#include "costs.hpp"

#include "digest/digest.hpp"
#include "text.hpp"

namespace figures {
namespace {

digest::Hash counted;

void print_line(const char* kind, const Name& name, uint32_t value) {
  const char* before = kind;
  for (const char* word : name.word) {
    if (word != nullptr) {
      port::print(before, word);
      before = ".";
    }
  }
  port::print(" ", value, "\n");
}

/// Runs a part, and prints its digest. Returns whether the answers are right.
bool run_part(const char* part, bool (*measure_part)()) {
  counted = digest::Hash();
  const bool right = measure_part();
  const uint64_t digest = counted.value();
  print_line("count ", {{part, "digest"}}, static_cast<uint32_t>(digest ^ digest >> 32));
  if (!right) {
    port::print(part, ": an answer is wrong\n");
  }
  return right;
}

}  // namespace

void add_figure([[maybe_unused]] const Name& name, [[maybe_unused]] uint32_t value) {
#if defined(FLASHBVH_CORE)
  print_line("figure ", name, value);
#endif
}

void add_count(const Name& name, uint32_t value) {
  print_line("count ", name, value);
  add_to_digest(value);
}

void add_to_digest(uint32_t count) {
  counted.add(count);
}

}  // namespace figures

int main() {
#if defined(FLASHBVH_CORE)
  port::print("core ", FLASHBVH_CORE, "\n");
#endif
  bool right = true;
#define PART(name) right = figures::run_part(#name, figures::measure_##name) && right;
  FLASHBVH_PARTS
#undef PART
  return right ? 0 : 1;
}
