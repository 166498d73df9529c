// The part of Catch2 that our tests use, for boards: no heap, no C++ library, no stdio, and
// compiled in a fraction of the time. Test sources include it as <catch2/catch.hpp>.
//
// TEST_CASE, TEMPLATE_TEST_CASE, TEMPLATE_TEST_CASE_SIG, CHECK, CHECK_FALSE, REQUIRE,
// REQUIRE_FALSE, STATIC_REQUIRE, FAIL, INFO of a string, CAPTURE. Differences from Catch2:
// - a failed REQUIRE or FAIL ends the process: there are no exceptions
// - values of classes print as {?}, floating-point numbers as a mantissa and an exponent
// - there is no SECTION and no GENERATE: tests that run on boards use separate test cases or loops
#pragma once

#include "../small_catch.hpp"

// `Decompose() <= a == b` relies on having no parentheses.
#pragma GCC diagnostic ignored "-Wparentheses"

#define SMALL_CATCH_JOIN_NOW(a, b) a##b
#define SMALL_CATCH_JOIN(a, b) SMALL_CATCH_JOIN_NOW(a, b)
#define SMALL_CATCH_UNIQUE(stem) SMALL_CATCH_JOIN(small_catch_##stem##_, __LINE__)
#define SMALL_CATCH_LIST(...) __VA_ARGS__
#define SMALL_CATCH_FIRST(first, ...) first

// EACH(m, context, a, b, ...) is m(context, n, a) m(context, n - 1, b) ..., for up to ten.
#define SMALL_CATCH_EACH_1(m, c, a) m(c, 1, a)
#define SMALL_CATCH_EACH_2(m, c, a, ...) m(c, 2, a) SMALL_CATCH_EACH_1(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_3(m, c, a, ...) m(c, 3, a) SMALL_CATCH_EACH_2(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_4(m, c, a, ...) m(c, 4, a) SMALL_CATCH_EACH_3(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_5(m, c, a, ...) m(c, 5, a) SMALL_CATCH_EACH_4(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_6(m, c, a, ...) m(c, 6, a) SMALL_CATCH_EACH_5(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_7(m, c, a, ...) m(c, 7, a) SMALL_CATCH_EACH_6(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_8(m, c, a, ...) m(c, 8, a) SMALL_CATCH_EACH_7(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_9(m, c, a, ...) m(c, 9, a) SMALL_CATCH_EACH_8(m, c, __VA_ARGS__)
#define SMALL_CATCH_EACH_10(m, c, a, ...) m(c, 10, a) SMALL_CATCH_EACH_9(m, c, __VA_ARGS__)
#define SMALL_CATCH_ELEVENTH(a, b, c, d, e, f, g, h, i, j, count, ...) count
#define SMALL_CATCH_COUNT(...) SMALL_CATCH_ELEVENTH(__VA_ARGS__, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)
#define SMALL_CATCH_EACH(m, c, ...) \
  SMALL_CATCH_JOIN(SMALL_CATCH_EACH_, SMALL_CATCH_COUNT(__VA_ARGS__))(m, c, __VA_ARGS__)

// Test cases.
#define SMALL_CATCH_REGISTER(id, name, tags, function)                            \
  static constexpr ::small_catch::Description id##_text = {name, tags, function}; \
  static ::small_catch::TestCase id##_case(id##_text);
#define SMALL_CATCH_REGISTER_AS(id, name, tags, function) \
  SMALL_CATCH_REGISTER(id, name, tags, function)

#define SMALL_CATCH_TEST_CASE(function, name, tags, ...)     \
  static void function();                                    \
  SMALL_CATCH_REGISTER_AS(function, name, "" tags, function) \
  static void function()
#define SMALL_CATCH_NAMED_TEST_CASE(...) SMALL_CATCH_TEST_CASE(__VA_ARGS__)
// The tags may be missing.
#define TEST_CASE(...) SMALL_CATCH_NAMED_TEST_CASE(SMALL_CATCH_UNIQUE(test), __VA_ARGS__, , )

#define SMALL_CATCH_INSTANCE_NOW(n, argument, function, name, tags)                     \
  SMALL_CATCH_REGISTER_AS(SMALL_CATCH_JOIN(function, _##n), name " - " #argument, tags, \
                          function<argument>)
#define SMALL_CATCH_INSTANCE_OF(...) SMALL_CATCH_INSTANCE_NOW(__VA_ARGS__)
#define SMALL_CATCH_INSTANCE(context, n, argument) \
  SMALL_CATCH_INSTANCE_OF(n, argument, SMALL_CATCH_LIST context)

#define SMALL_CATCH_TEMPLATE(function, name, tags, parameters, ...)           \
  template <parameters>                                                       \
  static void function();                                                     \
  SMALL_CATCH_EACH(SMALL_CATCH_INSTANCE, (function, name, tags), __VA_ARGS__) \
  template <parameters>                                                       \
  static void function()
#define SMALL_CATCH_NAMED_TEMPLATE(...) SMALL_CATCH_TEMPLATE(__VA_ARGS__)
#define TEMPLATE_TEST_CASE(name, tags, ...) \
  SMALL_CATCH_NAMED_TEMPLATE(SMALL_CATCH_UNIQUE(test), name, tags, class TestType, __VA_ARGS__)

// The signature is ((Type value), value): its first element, without the parentheses.
#define SMALL_CATCH_DECLARATION(signature) SMALL_CATCH_DECLARATION_OF(SMALL_CATCH_FIRST signature)
#define SMALL_CATCH_DECLARATION_OF(declaration) SMALL_CATCH_DECLARATION_NOW(declaration)
#define SMALL_CATCH_DECLARATION_NOW(declaration) SMALL_CATCH_LIST declaration
#define TEMPLATE_TEST_CASE_SIG(name, tags, signature, ...)         \
  SMALL_CATCH_NAMED_TEMPLATE(SMALL_CATCH_UNIQUE(test), name, tags, \
                             SMALL_CATCH_DECLARATION(signature), __VA_ARGS__)

// Assertions.
#define SMALL_CATCH_ASSERT(function, macro, text, ...)                                         \
  do {                                                                                         \
    static constexpr ::small_catch::Site small_catch_site = {macro, text, __FILE__, __LINE__}; \
    ::small_catch::function(small_catch_site, __VA_ARGS__);                                    \
  } while (false)
#define CHECK(...) \
  SMALL_CATCH_ASSERT(check, "CHECK", #__VA_ARGS__, ::small_catch::Decompose() <= __VA_ARGS__)
#define REQUIRE(...) \
  SMALL_CATCH_ASSERT(require, "REQUIRE", #__VA_ARGS__, ::small_catch::Decompose() <= __VA_ARGS__)
#define CHECK_FALSE(...)                                 \
  SMALL_CATCH_ASSERT(check, "CHECK_FALSE", #__VA_ARGS__, \
                     ::small_catch::Decompose() <= !static_cast<bool>(__VA_ARGS__))
#define REQUIRE_FALSE(...)                                   \
  SMALL_CATCH_ASSERT(require, "REQUIRE_FALSE", #__VA_ARGS__, \
                     ::small_catch::Decompose() <= !static_cast<bool>(__VA_ARGS__))
#define STATIC_REQUIRE(...) static_assert(__VA_ARGS__, #__VA_ARGS__)
#define FAIL(text) SMALL_CATCH_ASSERT(require, "FAIL", text, ::small_catch::Decompose() <= false)

// Values that a failed assertion also prints.
#define INFO(text) SMALL_CATCH_CAPTURED(SMALL_CATCH_UNIQUE(info), 1, text)
#define SMALL_CATCH_CAPTURED(stem, n, value) \
  const ::small_catch::Captured SMALL_CATCH_JOIN(stem, _##n)(#value, value);
#define CAPTURE(...) \
  SMALL_CATCH_EACH(SMALL_CATCH_CAPTURED, SMALL_CATCH_UNIQUE(capture), __VA_ARGS__)
