#include "value.hpp"

#include <float.h>

namespace small_catch {
namespace {

constexpr int kFractionBits = 60;  // leaves room for one decimal digit in 64 bits
constexpr uint64_t kOne = uint64_t{1} << kFractionBits;
constexpr int kDecimals = 10;
constexpr uint64_t kHalfOfLastDecimal = kOne / 20000000000u;
constexpr int kMantissaBits = 52;
constexpr int kExponentBias = 1075;  // of a mantissa read as an integer

/// Appends to a text that is long enough.
class Writer {
 public:
  explicit Writer(NumberText& number) : end_(number.text) { *end_ = '\0'; }

  void add(char letter) {
    *end_++ = letter;
    *end_ = '\0';
  }
  void add(const char* letters) {
    while (*letters != '\0') {
      add(*letters++);
    }
  }
  void add(uint64_t number) {
    char digits[20];
    int count = 0;
    do {
      digits[count++] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    while (count != 0) {
      add(digits[--count]);
    }
  }
  void drop_zeros() {
    while (end_[-1] == '0' && end_[-2] != '.') {
      *--end_ = '\0';
    }
  }

 private:
  char* end_;
};

void add_decimals(Writer& writer, uint64_t whole, uint64_t fraction) {
  fraction += kHalfOfLastDecimal;
  writer.add(whole + (fraction >> kFractionBits));
  writer.add('.');
  for (int i = 0; i < kDecimals; ++i) {
    fraction = (fraction & (kOne - 1)) * 10;
    writer.add(static_cast<char>('0' + (fraction >> kFractionBits)));
  }
  writer.drop_zeros();
}

/// Whether ten decimals show most of its digits.
bool is_large_enough(uint64_t mantissa, int exponent) {
  constexpr int kSmallest = 13;  // 2^-13
  return -exponent <= kSmallest || mantissa >> (-exponent - kSmallest) != 0;
}

/// mantissa * 2^exponent, in decimals if they show it.
void add_finite(Writer& writer, uint64_t mantissa, int exponent) {
  if (mantissa == 0) {
    exponent = 0;
  }
  while (mantissa != 0 && (mantissa & 1) == 0) {
    mantissa >>= 1;
    ++exponent;
  }
  if (exponent >= 0 && exponent < 64 && mantissa << exponent >> exponent == mantissa) {
    add_decimals(writer, mantissa << exponent, 0);
  } else if (exponent < 0 && exponent >= -kFractionBits && is_large_enough(mantissa, exponent)) {
    const uint64_t fraction = mantissa & ((uint64_t{1} << -exponent) - 1);
    add_decimals(writer, mantissa >> -exponent, fraction << (kFractionBits + exponent));
  } else {
    writer.add(mantissa);
    writer.add(" * 2^");
    if (exponent < 0) {
      writer.add('-');
    }
    writer.add(static_cast<uint64_t>(exponent < 0 ? -exponent : exponent));
  }
}

void add_double(Writer& writer, double value) {
  static_assert(DBL_MANT_DIG == kMantissaBits + 1, "IEEE binary64");
  uint64_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  const uint64_t mantissa = bits & ((uint64_t{1} << kMantissaBits) - 1);
  const int exponent = static_cast<int>(bits >> kMantissaBits & 0x7FF);
  if (bits >> 63 != 0) {
    writer.add('-');
  }
  if (exponent == 0x7FF) {
    writer.add(mantissa == 0 ? "inf" : "nan");
  } else if (exponent == 0) {
    add_finite(writer, mantissa, 1 - kExponentBias);
  } else {
    add_finite(writer, mantissa | uint64_t{1} << kMantissaBits, exponent - kExponentBias);
  }
}

}  // namespace

NumberText stringify(double value) {
  NumberText number;
  Writer writer(number);
  add_double(writer, value);
  return number;
}

NumberText stringify(float value) {
  NumberText number;
  Writer writer(number);
  add_double(writer, static_cast<double>(value));
  writer.add('f');
  return number;
}

void put_value(bool value) {
  port::put(value ? "true" : "false");
}

void put_value(char value) {
  const char quoted[] = {'\'', value, '\'', '\0'};
  port::put(quoted);
}

void put_value(const char* value) {
  if (value == nullptr) {
    port::put("nullptr");
    return;
  }
  port::put("\"");
  port::put(value);
  port::put("\"");
}

void put_value(const void* value) {
  const auto bits = reinterpret_cast<uintptr_t>(value);
  char text[2 + 2 * sizeof bits + 1] = "0x";
  for (size_t i = 0; i < 2 * sizeof bits; ++i) {
    text[2 + i] = "0123456789abcdef"[bits >> (8 * sizeof bits - 4 * (i + 1)) & 15u];
  }
  port::put(text);
}

}  // namespace small_catch
