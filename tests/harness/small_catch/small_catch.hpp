// The functions behind the macros of catch2/catch.hpp: assertions, messages, test cases.
#pragma once

/// Defined if the macros are this header's, not Catch2's.
#define FLASHBVH_SMALL_CATCH

#include <stddef.h>
#include <stdint.h>

#include "text.hpp"

namespace small_catch {

/// A number as text: mantissa and exponent, "3 * 2^-1", in integers alone.
void put_value(double value);
void put_value(bool value);
void put_value(const char* value);
void put_value(const void* value);
template <class Type>
void put_value(const Type* value) {
  put_value(static_cast<const void*>(value));
}
template <class Integer>
void put_value(Integer value) {
  port::put(value);
}

/// Prints a value of any type, by its address; for a class or 128 bits, only a mark.
template <class Type>
void put_any(const void* address) {
  const Type& value = *static_cast<const Type*>(address);
  if constexpr (__is_enum(Type)) {
    port::put(static_cast<int>(value));
  } else if constexpr (__is_class(Type) || __is_union(Type) || sizeof(Type) > sizeof(uint64_t)) {
    port::put("{?}");
  } else if constexpr (__is_same(Type, float)) {
    put_value(static_cast<double>(value));
  } else if constexpr (__is_same(Type, decltype(nullptr))) {
    port::put("nullptr");
  } else if constexpr (sizeof(Type) < sizeof(int) && !__is_same(Type, bool)) {
    port::put(static_cast<int>(value));
  } else {
    put_value(value);
  }
}

/// A value and the function that prints it.
struct AnyValue {
  const void* address;
  void (*put)(const void* address);
};

template <class Type>
AnyValue any_value(const Type& value) {
  return {__builtin_addressof(value), put_any<Type>};
}
template <size_t size>
AnyValue any_value(const char (&value)[size]) {
  return {value, [](const void* text) { put_value(static_cast<const char*>(text)); }};
}

/// An assertion's text and place.
struct Site {
  const char* macro;
  const char* expression;
  const char* file;
  int line;
};

/// Reports a failure of a comparison or, without `comparison`, of a value.
void report(const Site& site, const AnyValue& left, const char* comparison, const AnyValue& right);

/// Ends the process with status 120. The test program defines it.
[[noreturn]] void stop();

/// A comparison's two sides, so that a failure shows both.
template <class Left, class Right>
struct Comparison {
  const Left& left;
  const char* name;
  const Right& right;
  bool holds;

  explicit operator bool() const { return holds; }
  void report_at(const Site& site) const { report(site, any_value(left), name, any_value(right)); }
};

/// The left side of a comparison, or a whole expression without one.
template <class Left>
struct Operand {
  const Left& value;

#define SMALL_CATCH_COMPARE(op)                                            \
  template <class Right>                                                   \
  Comparison<Left, Right> operator op(const Right& right) const {          \
    return {value, " " #op " ", right, static_cast<bool>(value op right)}; \
  }
  SMALL_CATCH_COMPARE(==)
  SMALL_CATCH_COMPARE(!=)
  SMALL_CATCH_COMPARE(<)
  SMALL_CATCH_COMPARE(<=)
  SMALL_CATCH_COMPARE(>)
  SMALL_CATCH_COMPARE(>=)
#undef SMALL_CATCH_COMPARE

  explicit operator bool() const {
    return static_cast<bool>(value);
  }
  void report_at(const Site& site) const {
    report(site, any_value(value), nullptr, {});
  }
};

/// `Decompose() <= a == b` groups as `(Decompose() <= a) == b`.
struct Decompose {
  template <class Left>
  Operand<Left> operator<=(const Left& left) const {
    return {left};
  }
};

template <class Claim>
void check(const Site& site, const Claim& claim) {
  if (!claim) {
    claim.report_at(site);
  }
}

template <class Claim>
void require(const Site& site, const Claim& claim) {
  if (!claim) {
    claim.report_at(site);
    stop();
  }
}

/// A CAPTURE or INFO: a line that a failed assertion prints during its scope. Lines lie on the
/// stack, each with the address of the previous one.
class Message {
 public:
  Message(const char* name, const AnyValue& value);
  ~Message();
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

 private:
  friend void put_messages();

  const Message* const outer_;
  const char* const name_;
  const AnyValue value_;
};

template <class Type>
constexpr bool kIsCopied = !__is_class(Type) && !__is_union(Type);
template <class Element, size_t size>
constexpr bool kIsCopied<Element[size]> = false;

/// A copy of a value; for a class or an array, its address.
template <class Type, bool is_copied = kIsCopied<Type>>
struct Kept {
  explicit Kept(const Type& value) : kept(value) {}
  Type kept;
  AnyValue any() const { return any_value(kept); }
};
template <class Type>
struct Kept<Type, false> {
  explicit Kept(const Type& value) : kept(any_value(value)) {}
  AnyValue kept;
  AnyValue any() const { return kept; }
};

template <class Type>
class Captured {
 public:
  Captured(const char* name, const Type& value) : kept_(value), message_(name, kept_.any()) {}

 private:
  const Kept<Type> kept_;
  const Message message_;
};

/// A test case: static objects link themselves into a list before main(), in the order of the
/// sources. 8 bytes of RAM each on a 32-bit core; the description lies in flash.
struct Description {
  const char* name;
  const char* tags;
  void (*function)();
};

struct TestCase {
  explicit TestCase(const Description& description);

  const Description& description;
  TestCase* next = nullptr;
};

/// Runs like Catch2's main(), as far as CTest needs it:
///   program                          runs all test cases except those hidden by a tag `[.]`
///   program NAME...                  runs these, hidden or not; `\` quotes the next character
///   program --list-test-names-only   lists them; returns their number
///   program --list-reporters         for Catch.cmake
/// Returns the number of failures, at most 100, below the statuses of ports/run. It is a failure if
/// no test case matches.
int run(int argc, char** argv);

}  // namespace small_catch
