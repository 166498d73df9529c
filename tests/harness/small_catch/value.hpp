// Values as text, for the two sides of a failed assertion and for CAPTURE.
#ifndef FLASHBVH_SMALL_CATCH_VALUE_HPP
#define FLASHBVH_SMALL_CATCH_VALUE_HPP

#include <stddef.h>
#include <stdint.h>

#include "text.hpp"

namespace small_catch {

/// The text of a number.
struct NumberText {
  char text[40];

  friend bool operator==(const NumberText& number, const char* expected) {
    const char* own = number.text;
    while (*own != '\0' && *own == *expected) {
      ++own;
      ++expected;
    }
    return *own == *expected;
  }
};

/// Ten decimals, less the zeros at the end: "1.5". Where they would hide the value, mantissa and
/// exponent: "3 * 2^-40". Exact integers inside: needs no arithmetic of floats.
NumberText stringify(double value);
/// The same with an f after.
NumberText stringify(float value);

void put_value(bool value);
void put_value(char value);
void put_value(const char* value);
void put_value(const void* value);
inline void put_value(decltype(nullptr)) {
  port::put("nullptr");
}
inline void put_value(int value) {
  port::put(value);
}
inline void put_value(unsigned value) {
  port::put(value);
}
inline void put_value(long value) {
  port::put(value);
}
inline void put_value(unsigned long value) {
  port::put(value);
}
inline void put_value(long long value) {
  port::put(value);
}
inline void put_value(unsigned long long value) {
  port::put(value);
}
inline void put_value(double value) {
  port::put(stringify(value).text);
}
inline void put_value(float value) {
  port::put(stringify(value).text);
}

/// A value of any type, by its address.
template <class Type>
void put_any(const void* address) {
  const Type& value = *static_cast<const Type*>(address);
  if constexpr (__is_enum(Type)) {
    put_value(static_cast<__underlying_type(Type)>(value));
  } else if constexpr (__is_class(Type) || __is_union(Type)) {
    port::put("{?}");
  } else {
    put_value(value);
  }
}

/// A value whose type is told by the function that prints it.
struct AnyValue {
  const void* address;
  void (*put)(const void* address);
};

template <class Type>
AnyValue any_value(const Type& value) {
  return {__builtin_addressof(value), put_any<Type>};
}

}  // namespace small_catch

#endif
