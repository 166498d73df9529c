// What calls of the library cost: runs the parts that FLASHBVH_PARTS names, and prints their
// figures. Exits with 1 if an answer is wrong.
#include "costs.hpp"

#include <string.h>

#include "digest/digest.hpp"
#include "text.hpp"

namespace figures {
namespace {

enum class Kind : uint8_t { figure, count };

struct Row {
  Name name;
  Kind kind;
  uint32_t added;
  uint64_t sum;
  uint32_t most;
};

constexpr uint32_t kRows = 32;  // of a part
Row rows[kRows];
uint32_t row_count;
digest::Hash counted;

bool same(const char* a, const char* b) {
  return a == b || (a != nullptr && b != nullptr && strcmp(a, b) == 0);
}

bool same(const Name& a, const Name& b) {
  uint32_t i = 0;
  for (const char* word : a.word) {
    if (!same(word, b.word[i++])) {
      return false;
    }
  }
  return true;
}

/// The row of a name, added if it is new; the last row serves all names without a row.
Row& row_of(const Name& name, Kind kind) {
  uint32_t i = 0;
  while (i < row_count && !same(rows[i].name, name)) {
    ++i;
  }
  if (i == row_count && row_count < kRows) {
    rows[row_count++] = {name, kind, 0, 0, 0};
  }
  return rows[i < kRows ? i : kRows - 1];
}

void add(const Name& name, Kind kind, uint32_t value) {
  Row& row = row_of(name, kind);
  ++row.added;
  row.sum += value;
  row.most = value > row.most ? value : row.most;
}

void print_line(Kind kind, const Name& name, const char* last, uint32_t value) {
  port::put(kind == Kind::figure ? "figure " : "count ");
  const char* before = "";
  for (const char* word : name.word) {
    if (word != nullptr) {
      port::print(before, word);
      before = ".";
    }
  }
  port::print(last, value, "\n");
}

void print(const Row& row) {
#if !defined(FLASHBVH_CORE)
  if (row.kind == Kind::figure) {
    return;
  }
#endif
  if (row.added == 1) {
    print_line(row.kind, row.name, " ", row.most);
  } else {
    print_line(row.kind, row.name, ".mean ",
               static_cast<uint32_t>((row.sum + row.added / 2) / row.added));
    print_line(row.kind, row.name, ".max ", row.most);
  }
}

/// Prints and clears the rows of a part, and its digest. Returns whether there were enough rows and
/// the answers are right.
bool run_part(const char* part, bool (*measure_part)()) {
  row_count = 0;
  counted = digest::Hash();
  const bool right = measure_part();
  for (uint32_t i = 0; i < row_count; ++i) {
    print(rows[i]);
  }
  const uint64_t digest = counted.value();
  print_line(Kind::count, {{part, "digest"}}, " ", static_cast<uint32_t>(digest ^ digest >> 32));
  if (!right || row_count == kRows) {
    port::print(part, right ? ": more figures than rows\n" : ": an answer is wrong\n");
  }
  return right && row_count != kRows;
}

}  // namespace

void add_figure(const Name& name, uint32_t value) {
  add(name, Kind::figure, value);
}

void add_count(const Name& name, uint32_t value) {
  add(name, Kind::count, value);
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
