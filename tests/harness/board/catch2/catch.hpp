// The part of Catch2 that tests on boards use, without a heap, a C++ library or stdio: TEST_CASE,
// CHECK, REQUIRE, CHECK_FALSE, REQUIRE_FALSE, STATIC_REQUIRE, CAPTURE, INFO.
//
// A failed assertion prints its text, not its operands, and the captured values. A failed REQUIRE
// also ends the program, as there are no exceptions.
#pragma once

#include <stddef.h>

namespace board_catch {

/// A test case. Static objects link themselves into a list before main(), in the order of the
/// sources.
struct TestCase {
  TestCase(const char* name, void (*function)());

  const char* name;
  void (*function)();
  TestCase* next = nullptr;
};

/// A captured integer, text or floating-point number; the last prints as its bits.
struct Value {
  Value(const char* words) : text(words) {}
  Value(double value);
  Value(float value) : Value(static_cast<double>(value)) {}
  template <class Integer>
  Value(Integer value) : number(static_cast<long long>(value)) {}

  const char* text = nullptr;
  long long number = 0;
};

/// Values that a failed assertion prints while their scope lasts.
class Message {
 public:
  Message(const char* names, const Value* values, size_t count);
  ~Message();
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;
  static void print_all();

 private:
  const Message* const outer_;
  const char* const names_;
  const Value* const values_;
  const size_t count_;
};

template <size_t count>
struct Captured {
  const Value values[count];
  const Message message;

  template <class... Values>
  explicit Captured(const char* names, const Values&... captured)
      : values{Value(captured)...}, message(names, values, count) {}
};
template <class... Values>
Captured(const char*, const Values&...) -> Captured<sizeof...(Values)>;

/// Reports a failure unless `holds`. Returns `holds`.
bool check(bool holds, const char* text, const char* file, int line);
/// The same, and ends the program.
void require(bool holds, const char* text, const char* file, int line);

}  // namespace board_catch

#define BOARD_CATCH_JOIN_NOW(a, b) a##b
#define BOARD_CATCH_JOIN(a, b) BOARD_CATCH_JOIN_NOW(a, b)
#define BOARD_CATCH_TEST_CASE(function, name)                     \
  static void function();                                         \
  static ::board_catch::TestCase function##_case(name, function); \
  static void function()
#define BOARD_CATCH_NAMED(function, name) BOARD_CATCH_TEST_CASE(function, name)
#define TEST_CASE(name) BOARD_CATCH_NAMED(BOARD_CATCH_JOIN(test_, __LINE__), name)

#define CHECK(...) \
  (void)::board_catch::check(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)
#define REQUIRE(...) \
  ::board_catch::require(static_cast<bool>(__VA_ARGS__), #__VA_ARGS__, __FILE__, __LINE__)
#define CHECK_FALSE(...) CHECK(!(__VA_ARGS__))
#define REQUIRE_FALSE(...) REQUIRE(!(__VA_ARGS__))
#define STATIC_REQUIRE(...) static_assert(__VA_ARGS__, #__VA_ARGS__)
#define CAPTURE(...) \
  const ::board_catch::Captured BOARD_CATCH_JOIN(captured_, __LINE__)(#__VA_ARGS__, __VA_ARGS__)
#define INFO(text) CAPTURE(text)
