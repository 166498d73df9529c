// Decodes the properties on which an instruction's cycles depend. Encodings: Arm, ARMv7-M
// Architecture Reference Manual, DDI 0403, chapter A5, and ARMv8-M, DDI 0553, part C.
#pragma once

#include <cstdint>

namespace cycles {

/// Instructions of one kind share a row of a core's table.
enum class Kind : uint8_t {
  alu,
  it,
  multiply,
  multiply_add,
  multiply_long,
  multiply_add_long,
  divide,
  load,
  load_pc,
  load_pair,
  load_multiple,
  store,
  store_indexed,
  store_pair,
  store_multiple,
  branch,
  branch_register,
  call,
  call_register,
  compare_branch,
  table_branch,
  system,
  barrier,
  float_move,
  float_move_pair,
  float_simple,
  float_add,
  float_multiply,
  float_multiply_add,
  float_divide,
  float_root,
  float_load,
  float_store,
  vector,
};

constexpr uint8_t kKinds = static_cast<uint8_t>(Kind::vector) + 1;

struct Instruction {
  Kind kind = Kind::alu;
  uint8_t bytes = 2;
  uint8_t words = 0;            ///< number of words that it loads or stores
  uint8_t governed = 0;         ///< of an IT: number of conditional instructions after it
  bool is_double = false;       ///< arithmetic of doubles
  bool is_split = false;        ///< a 32-bit instruction in two words, by its address
  uint16_t address = 0;         ///< core registers, a bit each, from which an address is made
  uint16_t loaded = 0;          ///< core registers that a single load writes
  uint16_t updated = 0;         ///< the base register that a single load or store changes
  uint16_t computed = 0;        ///< core registers that data processing writes
  uint32_t floats_read = 0;     ///< single-precision registers, a bit each
  uint32_t floats_written = 0;  ///< by arithmetic
};

/// `second`: read only for 32-bit instructions.
Instruction decode(uint16_t first, uint16_t second);

/// Returns whether an instruction that begins with `first` has 32 bits.
constexpr bool is_wide(uint16_t first) {
  return first >= 0xE800;
}

}  // namespace cycles
