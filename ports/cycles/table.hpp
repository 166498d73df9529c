// The cycles of a core, read from tables/CORE.csv: a row a kind of instruction or a rule, with the
// place in the core's manual that it comes from.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "thumb.hpp"

namespace cycles {

/// How instructions that follow each other affect each other.
enum class Rule : uint8_t {
  load_after_load,   ///< saved by a load, or an indexed store, whose address needs no register of
                     ///< the load before
  base_update,       ///< not saved by such a load if it changes its base register
  load_after_store,  ///< added by a load, of one register or many, after a store
  base_wait,         ///< added by a store whose base register the store before changed
  address_wait,      ///< added where the instruction before computed the address
  folded_it,         ///< saved by an IT after an instruction of 16 bits
  wide_target,       ///< added by a jump to 32 bits that are not in one word
  fetch_wait,        ///< added by the third of such in a row after an instruction of several cycles
  float_wait,        ///< added where the instruction before computed an operand
  double_precision,  ///< added to arithmetic of doubles
  literal_wait,      ///< at most added to a load of a literal; of bounds alone
  unaligned_word,    ///< added to a word in two words; of bounds alone
};

constexpr uint8_t kRules = static_cast<uint8_t>(Rule::unaligned_word) + 1;

struct Row {
  uint16_t cycles = 0;
  uint16_t per_word = 0;  ///< in addition, for each word that is loaded or stored
  uint16_t jump = 0;      ///< in addition, where the next instruction is another one
};

/// Where the manual gives a range, by what the model does not see.
enum class Range : uint8_t { assumed, least, most };

const char* name_of(Kind kind);

class Table {
 public:
  /// Returns what is wrong, as one line that names the file; empty if nothing is.
  std::string read(const std::string& path, Range range);

  const Row& operator[](Kind kind) const { return rows_[static_cast<uint8_t>(kind)]; }
  void set(Kind kind, const Row& row) { rows_[static_cast<uint8_t>(kind)] = row; }
  /// Whether the core has instructions of that kind.
  bool has(Kind kind) const { return has_row_[static_cast<uint8_t>(kind)]; }
  uint16_t operator[](Rule rule) const { return rules_[static_cast<uint8_t>(rule)]; }

 private:
  std::string read_line(const std::string& line, Range range);

  std::array<Row, kKinds> rows_;
  std::array<bool, kKinds> has_row_{};
  std::array<uint16_t, kRules> rules_{};
};

}  // namespace cycles
