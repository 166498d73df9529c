#include "text.hpp"

#include "semihosting.hpp"
#include "text.h"

namespace port {
namespace {

template <class Unsigned>
void put_decimal(Unsigned magnitude, bool negative) {
  char digits[22];  // sign, 20 digits, end
  char* first = digits + sizeof digits - 1;
  *first = '\0';
  do {
    *--first = static_cast<char>('0' + magnitude % 10);
    magnitude /= 10;
  } while (magnitude != 0);
  if (negative) {
    *--first = '-';
  }
  put(first);
}

// The unsigned difference from 0 is also correct for the most negative value.
template <class Unsigned, class Signed>
void put_signed(Signed value) {
  const auto bits = static_cast<Unsigned>(value);
  put_decimal(value < 0 ? Unsigned{0} - bits : bits, value < 0);
}

}  // namespace

void put(const char* text) {
  call_host(HostCall::write0, text);
}

void put(int value) {
  put_signed<unsigned>(value);
}

void put(unsigned value) {
  put_decimal(value, false);
}

void put(long value) {
  put_signed<unsigned long>(value);
}

void put(unsigned long value) {
  put_decimal(value, false);
}

void put(long long value) {
  put_signed<unsigned long long>(value);
}

void put(unsigned long long value) {
  put_decimal(value, false);
}

}  // namespace port

void port_put(const char* text) {
  port::put(text);
}

void port_put_number(long value) {
  port::put(value);
}
