// The cycles of a core, read from tables/CORE.csv. A row has a kind of instruction or a rule, with
// its source in the core's manual.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "thumb.hpp"

namespace cycles {

/// How consecutive instructions affect each other's cycles.
enum class Rule : uint8_t {
  load_after_load,   ///< saved by a load or an indexed store after a load, if its address needs no
                     ///< register of that load
  base_update,       ///< lost from this saving if the load changes its base register
  load_after_store,  ///< added to a load, of one register or many, after a store
  base_wait,         ///< added to a store whose base register the previous store changed
  address_wait,      ///< added if the previous instruction computed the address
  folded_it,         ///< saved by an IT after a 16-bit instruction
  wide_target,       ///< added to a jump to a 32-bit instruction in two words
  fetch_wait,        ///< added to the third such instruction in a row after one of several cycles
  float_wait,        ///< added if the previous instruction computed an operand
  double_precision,  ///< added to arithmetic of doubles
  literal_wait,      ///< most that is added to a load of a literal; only for bounds
  unaligned_word,    ///< added to an access of a word that lies in two words; only for bounds
};

constexpr uint8_t kRules = static_cast<uint8_t>(Rule::unaligned_word) + 1;

struct Row {
  uint16_t cycles = 0;
  uint16_t per_word = 0;  ///< in addition, per word that is loaded or stored
  uint16_t jump = 0;      ///< in addition, if execution jumps
};

/// Which number of a manual's range to use, as its cause is invisible to the model.
enum class Range : uint8_t { assumed, least, most };

const char* name_of(Kind kind);

class Table {
 public:
  /// Returns an error as one line that names the file; empty if there is none.
  std::string read(const std::string& path, Range range);

  const Row& operator[](Kind kind) const { return rows_[static_cast<uint8_t>(kind)]; }
  void set(Kind kind, const Row& row) { rows_[static_cast<uint8_t>(kind)] = row; }
  /// Returns whether the core has instructions of this kind.
  bool has(Kind kind) const { return has_row_[static_cast<uint8_t>(kind)]; }
  uint16_t operator[](Rule rule) const { return rules_[static_cast<uint8_t>(rule)]; }

 private:
  std::string read_line(const std::string& line, Range range);

  std::array<Row, kKinds> rows_;
  std::array<bool, kKinds> has_row_{};
  std::array<uint16_t, kRules> rules_{};
};

}  // namespace cycles
