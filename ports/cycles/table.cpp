#include "table.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace cycles {
namespace {

constexpr const char* kKindNames[] = {"alu",
                                      "it",
                                      "multiply",
                                      "multiply_add",
                                      "multiply_long",
                                      "multiply_add_long",
                                      "divide",
                                      "load",
                                      "load_pc",
                                      "load_pair",
                                      "load_multiple",
                                      "store",
                                      "store_indexed",
                                      "store_pair",
                                      "store_multiple",
                                      "branch",
                                      "branch_register",
                                      "call",
                                      "call_register",
                                      "compare_branch",
                                      "table_branch",
                                      "system",
                                      "barrier",
                                      "float_move",
                                      "float_move_pair",
                                      "float_simple",
                                      "float_add",
                                      "float_multiply",
                                      "float_multiply_add",
                                      "float_divide",
                                      "float_root",
                                      "float_load",
                                      "float_store",
                                      "vector"};
constexpr const char* kRuleNames[] = {"load_after_load",  "base_update",  "load_after_store",
                                      "base_wait",        "address_wait", "folded_it",
                                      "wide_target",      "fetch_wait",   "float_wait",
                                      "double_precision", "literal_wait", "unaligned_word"};
static_assert(sizeof kKindNames / sizeof *kKindNames == kKinds, "a name a kind");
static_assert(sizeof kRuleNames / sizeof *kRuleNames == kRules, "a name a rule");

template <size_t N>
size_t index_of(const char* const (&names)[N], const std::string& name) {
  return static_cast<size_t>(std::find(names, names + N, name) - names);
}

/// Reads a number; an empty cell is 0.
bool read_number(const std::string& cell, uint16_t& number) {
  number = 0;
  for (const char digit : cell) {
    if (digit < '0' || digit > '9' || number > 999) {
      return false;
    }
    number = static_cast<uint16_t>(10 * number + (digit - '0'));
  }
  return true;
}

/// Reads "7", or "2-7-12": least, assumed and most cycles.
bool read_cycles(const std::string& cell, Range range, uint16_t& cycles) {
  std::istringstream parts(cell);
  std::string least;
  std::string assumed;
  std::string most;
  std::getline(parts, least, '-');
  if (!std::getline(parts, assumed, '-')) {
    return !cell.empty() && read_number(cell, cycles);
  }
  std::getline(parts, most);
  return !most.empty() && read_number(range == Range::least  ? least
                                      : range == Range::most ? most
                                                             : assumed,
                                      cycles);
}

}  // namespace

std::string Table::read_line(const std::string& line, Range range) {
  std::istringstream cells(line);
  std::string name;
  std::string cycles;
  std::string per_word;
  std::string jump;
  std::getline(cells, name, ',');
  std::getline(cells, cycles, ',');
  std::getline(cells, per_word, ',');
  std::getline(cells, jump, ',');
  Row row;
  if (!read_cycles(cycles, range, row.cycles) || !read_number(per_word, row.per_word) ||
      !(jump.empty() || read_cycles(jump, range, row.jump))) {
    return "'" + name + "': cycles, words and jump have to be numbers, as 7 or 2-7-12, below 10000";
  }
  const size_t kind = index_of(kKindNames, name);
  const size_t rule = index_of(kRuleNames, name);
  if (kind < kKinds) {
    rows_[kind] = row;
    has_row_[kind] = true;
  } else if (rule < kRules) {
    rules_[rule] = row.cycles;
  } else {
    return "'" + name + "' is no kind of instruction and no rule";
  }
  return "";
}

const char* name_of(Kind kind) {
  return kKindNames[static_cast<uint8_t>(kind)];
}

std::string Table::read(const std::string& path, Range range) {
  std::ifstream file(path);
  if (!file) {
    return path + ": cannot be read";
  }
  std::string line;
  std::getline(file, line);  // the head
  for (int number = 2; std::getline(file, line); ++number) {
    const std::string wrong = read_line(line, range);
    if (!wrong.empty()) {
      return std::string(path)
          .append(":")
          .append(std::to_string(number))
          .append(": ")
          .append(wrong);
    }
  }
  return "";
}

}  // namespace cycles
