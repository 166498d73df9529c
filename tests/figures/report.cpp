#include "report.hpp"

#include <string.h>

#include "digest/digest.hpp"
#include "text.hpp"

namespace figures {
namespace {

#if defined(FLASHBVH_CORE)
constexpr const char* kCore = FLASHBVH_CORE;
#else
constexpr const char* kCore = nullptr;
#endif

enum class Kind : uint8_t { figure, count, quotient };
constexpr const char* kKinds[] = {"figure ", "count ", "quotient "};

struct Row {
  Name name;
  Kind kind;
  uint32_t added;
  uint64_t sum;
  uint32_t whole;  ///< of a quotient
  uint32_t most;
  uint32_t whole_of_most;
};

constexpr uint32_t kRows = 40;  // the smallest board has memory for them
Row rows[kRows];
uint32_t row_count;
bool are_too_many;
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
    rows[row_count++] = {name, kind, 0, 0, 0, 0, 0};
  }
  return rows[i < kRows ? i : kRows - 1];
}

/// Prints a name; the core precedes the first one.
void put_name(Kind kind, const Name& name, const char* last) {
  static bool begun = false;
  if (!begun && kCore != nullptr) {
    port::print("core ", kCore, "\n");
  }
  begun = true;
  port::put(kKinds[static_cast<uint32_t>(kind)]);
  const char* before = "";
  for (const char* word : name.word) {
    if (word == nullptr) {
      continue;
    }
    port::put(before);
    before = ".";
    for (; *word != '\0'; ++word) {
      const char letter[] = {*word == ' ' ? '_' : *word, '\0'};
      port::put(letter);
    }
  }
  port::put(last);
}

void print_line(Kind kind, const Name& name, const char* last, uint64_t value) {
  put_name(kind, name, last);
  port::print(static_cast<unsigned long long>(value), "\n");
}

void print_quotient(const Name& name, const char* last, uint64_t part, uint32_t whole) {
  if (whole != 0) {
    put_name(Kind::quotient, name, last);
    port::print(static_cast<unsigned long long>(part), " ", whole, "\n");
  }
}

void print(const Row& row) {
  if (row.kind != Kind::count && kCore == nullptr) {
    return;
  }
  if (row.kind == Kind::quotient) {
    print_quotient(row.name, ".mean ", row.sum, row.whole);
    print_quotient(row.name, ".max ", row.most, row.whole_of_most);
  } else if (row.added == 1) {
    print_line(row.kind, row.name, " ", row.most);
  } else {
    print_line(row.kind, row.name, ".mean ", (row.sum + row.added / 2) / row.added);
    print_line(row.kind, row.name, ".max ", row.most);
  }
}

void add(const Name& name, Kind kind, uint32_t value) {
  Row& row = row_of(name, kind);
  ++row.added;
  row.sum += value;
  row.most = value > row.most ? value : row.most;
}

}  // namespace

void add_figure(const Name& name, uint32_t value) {
  add(name, Kind::figure, value);
}

void add_count(const Name& name, uint32_t value) {
  add(name, Kind::count, value);
  add_to_digest(value);
}

void add_quotient(const Name& name, int64_t part, uint32_t whole) {
  Row& row = row_of(name, Kind::quotient);
  row.sum += static_cast<uint64_t>(part);
  row.whole += whole;
  if (whole >= kFewParts && part > 0 &&
      static_cast<uint64_t>(part) * row.whole_of_most >= uint64_t{row.most} * whole) {
    row.most = static_cast<uint32_t>(part);
    row.whole_of_most = whole;
  }
}

void add_to_digest(uint32_t count) {
  counted.add(count);
}

void print_figure(const Name& name, uint32_t value) {
  print_line(Kind::figure, name, " ", value);
}

void print_count(const Name& name, uint32_t value) {
  print_line(Kind::count, name, " ", value);
}

void print_rows() {
  are_too_many = are_too_many || row_count == kRows;
  for (uint32_t i = 0; i < row_count; ++i) {
    print(rows[i]);
  }
  row_count = 0;
}

int print_all(const char* set, bool right) {
  print_rows();
  if (set != nullptr) {
    const uint64_t digest = counted.value();
    print_count({{set, "digest"}}, static_cast<uint32_t>(digest ^ digest >> 32));
  }
  port::put(are_too_many ? "There are more figures than rows\n"
            : right      ? ""
                         : "An answer is wrong\n");
  return right && !are_too_many ? 0 : 1;
}

}  // namespace figures
