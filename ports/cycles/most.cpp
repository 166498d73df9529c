// flashbvh_most_cycles TABLE.csv [fast]: the most cycles of instructions, for
// proofs/machine_code/measure.py. fast: for parts whose MULS takes the table's assumed cycles.
//
// First prints the core's rules, "WIDE_TARGET UNALIGNED_WORD". Then reads lines of one or two
// instructions, as halfwords in hexadecimal in objdump's order, and prints for each line
//   KIND CYCLES JUMP READS ADDRESS     for one: "no_KIND" if the core lacks it; READS: words that
//                                      may come from flash; ADDRESS as in thumb.hpp
//   CYCLES                             for "FIRST / SECOND": the most that SECOND waits
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "pipeline.hpp"
#include "table.hpp"

namespace cycles {
namespace {

constexpr uint16_t kSp = 1U << 13;

/// Words that may be read from flash; the stack lies in RAM.
unsigned reads(const Instruction& code) {
  switch (code.kind) {
    case Kind::load:
    case Kind::load_pc:
    case Kind::load_pair:
    case Kind::load_multiple:
    case Kind::float_load:
      return code.address == kSp ? 0 : code.words;
    case Kind::table_branch:
      return 1;
    default:
      return 0;
  }
}

unsigned cycles_of(const Table& table, const Instruction& code) {
  const Row& row = table[code.kind];
  const bool is_literal =
      (code.kind == Kind::load || code.kind == Kind::float_load) && code.address == 0;
  return row.cycles + unsigned{row.per_word} * code.words +
         (code.is_double ? table[Rule::double_precision] : 0U) +
         (is_literal ? table[Rule::literal_wait] : 0U);
}

bool is_known(const Table& table, const Instruction& code) {
  return table.has(code.kind) && !(code.is_double && table[Rule::double_precision] == 0);
}

Instruction read_code(std::istream& halfwords) {
  unsigned first = 0;
  unsigned second = 0;
  halfwords >> std::hex >> first;
  if (is_wide(static_cast<uint16_t>(first))) {
    halfwords >> second;
  }
  return decode(static_cast<uint16_t>(first), static_cast<uint16_t>(second));
}

/// Upper bound on the wait of `next` after `last`. The third wide instruction in two words waits
/// after an instruction of several cycles; here the first one is charged.
unsigned wait(const Table& table, const Instruction& last, const Instruction& next) {
  const bool may_take_several =
      cycles_of(table, last) > 1 || last.address != 0 || last.floats_read != 0;
  return wait_between(table, last, next) +
         (may_take_several && next.bytes == 4 ? table[Rule::fetch_wait] : 0U);
}

void answer(const Table& table, const std::string& line) {
  std::istringstream halfwords(line);
  const Instruction code = read_code(halfwords);
  std::string slash;
  if (halfwords >> slash) {
    std::cout << wait(table, code, read_code(halfwords)) << std::endl;
  } else {
    std::cout << (is_known(table, code) ? "" : "no_") << name_of(code.kind) << " "
              << cycles_of(table, code) << " " << table[code.kind].jump << " " << reads(code) << " "
              << code.address << std::endl;
  }
}

std::string read_table(const std::vector<std::string>& arguments, Table& table) {
  const bool is_fast = arguments.size() == 2 && arguments[1] == "fast";
  if (arguments.size() != (is_fast ? 2 : 1)) {
    return "give one table of ports/cycles/tables, and maybe 'fast'";
  }
  std::string wrong = table.read(arguments[0], Range::most);
  Table assumed;
  if (is_fast && wrong.empty() && (wrong = assumed.read(arguments[0], Range::assumed)).empty()) {
    table.set(Kind::multiply, assumed[Kind::multiply]);
  }
  return wrong;
}

}  // namespace
}  // namespace cycles

int main(int count, char** arguments) {
  cycles::Table table;
  const std::string wrong = cycles::read_table({arguments + 1, arguments + count}, table);
  if (!wrong.empty()) {
    std::cerr << "flashbvh_most_cycles: " << wrong << "\n";
    return 1;
  }
  std::cout << table[cycles::Rule::wide_target] << " " << table[cycles::Rule::unaligned_word]
            << std::endl;
  for (std::string line; std::getline(std::cin, line);) {
    cycles::answer(table, line);
  }
  return 0;
}
