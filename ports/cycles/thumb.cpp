#include "thumb.hpp"

namespace cycles {
namespace {

constexpr unsigned kPc = 15;

constexpr unsigned bits(unsigned word, unsigned low, unsigned count) {
  return word >> low & ((1U << count) - 1);
}

constexpr bool bit(unsigned word, unsigned place) {
  return bits(word, place, 1) != 0;
}

/// A register as a bit; 0 for the program counter, which is no operand of later instructions.
constexpr uint16_t mask(unsigned core_register) {
  return core_register == kPc ? 0 : static_cast<uint16_t>(1U << core_register);
}

unsigned count(unsigned list) {
  return static_cast<unsigned>(__builtin_popcount(list));
}

Instruction computes(Kind kind, unsigned result) {
  Instruction made;
  made.kind = kind;
  made.computed = mask(result);
  return made;
}

Instruction of(Kind kind) {
  return computes(kind, kPc);
}

/// Data processing; a jump if the result is the program counter.
Instruction computes_or_jumps(unsigned result) {
  return result == kPc ? of(Kind::branch_register) : computes(Kind::alu, result);
}

Instruction transfers(Kind kind, unsigned words, uint16_t address) {
  Instruction made = of(kind);
  made.words = static_cast<uint8_t>(words);
  made.address = address;
  return made;
}

Instruction loads(unsigned to, uint16_t address) {
  Instruction made = transfers(to == kPc ? Kind::load_pc : Kind::load, 1, address);
  made.loaded = mask(to);
  return made;
}

Instruction moves_multiple(bool is_load, unsigned list, unsigned base) {
  return transfers(is_load ? Kind::load_multiple : Kind::store_multiple, count(list), mask(base));
}

Instruction narrow_data_processing(unsigned code) {
  const unsigned operation = bits(code, 6, 4);
  constexpr unsigned kMultiply = 13;
  const bool only_compares = operation == 8 || operation == 10 || operation == 11;
  return computes(operation == kMultiply ? Kind::multiply : Kind::alu,
                  only_compares ? kPc : bits(code, 0, 3));
}

/// ADD, CMP, MOV of high registers; BX, BLX.
Instruction narrow_special(unsigned code) {
  const unsigned result = bits(code, 7, 1) << 3 | bits(code, 0, 3);
  switch (bits(code, 8, 2)) {
    case 1:
      return of(Kind::alu);
    case 3:
      return of(bit(code, 7) ? Kind::call_register : Kind::branch_register);
    default:
      return computes_or_jumps(result);
  }
}

Instruction narrow_indexed(unsigned code) {
  const auto address = static_cast<uint16_t>(mask(bits(code, 3, 3)) | mask(bits(code, 6, 3)));
  const bool is_store = bits(code, 9, 3) < 3;
  return is_store ? transfers(Kind::store_indexed, 1, address) : loads(bits(code, 0, 3), address);
}

Instruction narrow_transfer(bool is_load, unsigned value, unsigned base) {
  return is_load ? loads(value, mask(base)) : transfers(Kind::store, 1, mask(base));
}

Instruction narrow_it(unsigned code) {
  Instruction made = of(Kind::it);
  made.governed = static_cast<uint8_t>(4 - __builtin_ctz(bits(code, 0, 4)));
  return made;
}

Instruction narrow_miscellaneous(unsigned code) {
  constexpr unsigned kSp = 13;
  switch (bits(code, 8, 4)) {
    case 0x0:
      return computes(Kind::alu, kSp);
    case 0x1:
    case 0x3:
    case 0x9:
    case 0xB:
      return of(Kind::compare_branch);
    case 0x2:
    case 0xA:
      return computes(Kind::alu, bits(code, 0, 3));
    case 0x4:
    case 0x5:
      return moves_multiple(false, bits(code, 0, 9), kSp);
    case 0xC:
    case 0xD:
      return moves_multiple(true, bits(code, 0, 9), kSp);
    case 0xF:
      return bits(code, 0, 4) != 0 ? narrow_it(code) : of(Kind::alu);
    default:
      return of(Kind::system);
  }
}

Instruction narrow_immediate(unsigned code) {
  const unsigned low = bits(code, 0, 3);
  const unsigned high = bits(code, 8, 3);
  switch (bits(code, 11, 2)) {
    case 0:
      return computes(Kind::alu, high);
    case 1:
      return of(Kind::alu);
    default:
      return computes(Kind::alu, code < 0x2000 ? low : high);
  }
}

Instruction decode_narrow(unsigned code) {
  constexpr unsigned kSp = 13;
  const unsigned low = bits(code, 0, 3);
  const unsigned high = bits(code, 8, 3);
  switch (bits(code, 12, 4)) {
    case 0x0:
    case 0x1:
      return computes(Kind::alu, low);
    case 0x2:
    case 0x3:
      return narrow_immediate(code);
    case 0x4:
      return code < 0x4400   ? narrow_data_processing(code)
             : code < 0x4800 ? narrow_special(code)
                             : loads(high, 0);
    case 0x5:
      return narrow_indexed(code);
    case 0x9:
      return narrow_transfer(bit(code, 11), high, kSp);
    case 0xA:
      return computes(Kind::alu, high);
    case 0xB:
      return narrow_miscellaneous(code);
    case 0xC:
      return moves_multiple(bit(code, 11), bits(code, 0, 8), high);
    case 0xD:
      return of(bits(code, 8, 4) < 0xE ? Kind::branch : Kind::system);
    case 0xE:
      return of(Kind::branch);
    default:
      return narrow_transfer(bit(code, 11), low, bits(code, 3, 3));
  }
}

/// LDRD, STRD, exclusive accesses, TBB, TBH.
Instruction wide_pair(unsigned first, unsigned second) {
  const uint16_t base = mask(bits(first, 0, 4));
  const bool is_load = bit(first, 4);
  if ((first & 0xFFF0) == 0xE8D0 && (second & 0xFFE0) == 0xF000) {
    return of(Kind::table_branch);
  }
  const bool is_exclusive = !bit(first, 8) && !bit(first, 5);
  if (is_exclusive) {
    return is_load ? loads(bits(second, 12, 4), base) : transfers(Kind::store_indexed, 1, base);
  }
  return transfers(is_load ? Kind::load_pair : Kind::store_pair, 2, base);
}

Instruction wide_branch(unsigned first, unsigned second) {
  const bool is_conditional_or_system = !bit(second, 12) && !bit(second, 14);
  if (!is_conditional_or_system) {
    return of(bit(second, 12) && bit(second, 14) ? Kind::call : Kind::branch);
  }
  if ((first & 0x0380) != 0x0380) {
    return of(Kind::branch);
  }
  const unsigned operation = bits(first, 4, 7);
  return of(operation == 0x3A ? Kind::alu : operation == 0x3B ? Kind::barrier : Kind::system);
}

Instruction wide_transfer(unsigned first, unsigned second) {
  const unsigned base = bits(first, 0, 4);
  const unsigned value = bits(second, 12, 4);
  const bool is_literal = base == kPc;
  const bool is_indexed = !is_literal && !bit(first, 7) && bits(second, 6, 6) == 0;
  const auto address =
      static_cast<uint16_t>(mask(base) | (is_indexed ? mask(bits(second, 0, 4)) : 0));
  const bool is_word = bits(first, 5, 2) == 2;
  if (bit(first, 4) && value == kPc && !is_word) {
    return of(Kind::alu);  // a PLD
  }
  Instruction made = bit(first, 4)
                         ? loads(value, address)
                         : transfers(is_indexed ? Kind::store_indexed : Kind::store, 1, address);
  const bool updates = !is_literal && !bit(first, 7) && bit(second, 11) && bit(second, 8);
  made.updated = updates ? mask(base) : 0;
  return made;
}

Instruction wide_multiply(unsigned second) {
  const bool adds = bits(second, 12, 4) != kPc;
  return computes(adds ? Kind::multiply_add : Kind::multiply, bits(second, 8, 4));
}

Instruction wide_long_multiply(unsigned first, unsigned second) {
  const unsigned operation = bits(first, 4, 3);
  const bool is_division = (operation & 5) == 1;
  if (is_division) {
    return computes(Kind::divide, bits(second, 8, 4));
  }
  Instruction made =
      computes(operation < 4 ? Kind::multiply_long : Kind::multiply_add_long, bits(second, 8, 4));
  made.computed = static_cast<uint16_t>(made.computed | mask(bits(second, 12, 4)));
  return made;
}

/// The registers of a floating-point instruction, as bits of singles.
struct Floats {
  uint32_t d;
  uint32_t n;
  uint32_t m;
};

uint32_t float_mask(bool is_double, unsigned four, bool one) {
  // Doubles beyond the 16th have no singles.
  return is_double ? (one ? 0 : 3U << (2 * four)) : 1U << (2 * four + (one ? 1 : 0));
}

Floats floats_of(unsigned first, unsigned second) {
  const bool is_double = bit(second, 8);
  return {float_mask(is_double, bits(second, 12, 4), bit(first, 6)),
          float_mask(is_double, bits(first, 0, 4), bit(second, 7)),
          float_mask(is_double, bits(second, 0, 4), bit(second, 5))};
}

Instruction float_arithmetic(Kind kind, uint32_t written, uint32_t read, bool is_double) {
  Instruction made = of(kind);
  made.floats_written = written;
  made.floats_read = read;
  made.is_double = is_double;
  return made;
}

/// Instructions of one operand: VMOV, VABS, VNEG, VSQRT, VCMP, VCVT.
Instruction float_unary(unsigned first, unsigned second, const Floats& floats) {
  const bool is_double = bit(second, 8);
  const unsigned operation = bits(first, 0, 4);
  const bool is_immediate = !bit(second, 6);
  if (is_immediate || operation == 0) {
    return float_arithmetic(Kind::float_simple, 0, is_immediate ? 0 : floats.m, is_double);
  }
  if (operation == 1) {
    return bit(second, 7) ? float_arithmetic(Kind::float_root, floats.d, floats.m, is_double)
                          : float_arithmetic(Kind::float_simple, 0, floats.m, is_double);
  }
  const bool compares = operation == 4 || operation == 5;
  return compares ? float_arithmetic(Kind::float_simple, 0, floats.d | floats.m, is_double)
                  : float_arithmetic(Kind::float_add, floats.d, floats.m, is_double);
}

Instruction float_processing(unsigned first, unsigned second) {
  const Floats floats = floats_of(first, second);
  const bool is_double = bit(second, 8);
  const uint32_t two = floats.n | floats.m;
  switch (bits(first, 4, 4) & 0xB) {
    case 0x2:
      return float_arithmetic(Kind::float_multiply, floats.d, two, is_double);
    case 0x3:
      return float_arithmetic(Kind::float_add, floats.d, two, is_double);
    case 0x8:
      return float_arithmetic(Kind::float_divide, floats.d, two, is_double);
    case 0xB:
      return float_unary(first, second, floats);
    default:
      return float_arithmetic(Kind::float_multiply_add, floats.d, two | floats.d, is_double);
  }
}

Instruction float_transfer(unsigned first, unsigned second) {
  const bool is_load = bit(first, 4);
  if ((first & 0xFFE0) == 0xEC40) {
    return of(Kind::float_move_pair);
  }
  const bool is_single = bit(first, 8) && !bit(first, 5);
  const unsigned words = !is_single ? bits(second, 0, 8) & 0xFE : 1U + (bit(second, 8) ? 1 : 0);
  const unsigned odd = !is_single && !bit(second, 8) ? bits(second, 0, 1) : 0;
  Instruction made = transfers(is_load ? Kind::float_load : Kind::float_store, words + odd,
                               mask(bits(first, 0, 4)));
  if (!is_load) {
    made.floats_read = floats_of(first, second).d;
  }
  return made;
}

Instruction decode_coprocessor(unsigned first, unsigned second) {
  const bool is_float = bits(second, 9, 3) == 5;
  if (!is_float || (first & 0xFF00) == 0xEF00 || (first & 0xFF00) == 0xFF00) {
    return of(Kind::vector);
  }
  if ((first & 0xFF00) == 0xFE00) {
    return of(Kind::float_simple);  // VSEL, VMAXNM, VRINT
  }
  if ((first & 0xFF00) != 0xEE00) {
    return float_transfer(first, second);
  }
  if (!bit(second, 4)) {
    return float_processing(first, second);
  }
  Instruction made = of(Kind::float_move);
  made.floats_read = bit(first, 4) ? floats_of(first, second).n : 0;
  return made;
}

Instruction decode_wide(unsigned first, unsigned second) {
  if ((first & 0xEC00) == 0xEC00) {
    return decode_coprocessor(first, second);
  }
  if ((first & 0xFE00) == 0xE800) {
    return bit(first, 6) ? wide_pair(first, second)
                         : moves_multiple(bit(first, 4), second, bits(first, 0, 4));
  }
  if ((first & 0xF800) == 0xF000 && bit(second, 15)) {
    return wide_branch(first, second);
  }
  if ((first & 0xFE00) == 0xF800) {
    return wide_transfer(first, second);
  }
  if ((first & 0xFF80) == 0xFB00) {
    return wide_multiply(second);
  }
  if ((first & 0xFF80) == 0xFB80) {
    return wide_long_multiply(first, second);
  }
  return computes(Kind::alu, bits(second, 8, 4));
}

}  // namespace

Instruction decode(uint16_t first, uint16_t second) {
  if (!is_wide(first)) {
    return decode_narrow(first);
  }
  Instruction made = decode_wide(first, second);
  made.bytes = 4;
  return made;
}

}  // namespace cycles
