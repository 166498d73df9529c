#include "small_catch.hpp"

namespace small_catch {
namespace {

constexpr unsigned kMostFailures = 100;
constexpr int kNothingRan = 101;

unsigned failures = 0;
const Message* innermost = nullptr;
TestCase* first_case = nullptr;
TestCase* last_case = nullptr;
const char* running = "";

bool equal(const char* a, const char* b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

/// Whether an argument without its backslashes is this name.
bool names(const char* argument, const char* name) {
  for (;; ++argument, ++name) {
    if (*argument == '\\' && argument[1] != '\0') {
      ++argument;
    }
    if (*argument != *name || *name == '\0') {
      return *argument == *name;
    }
  }
}

bool is_selected(int argc, char** argv, const Description& test) {
  bool any = false;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '-' && argv[i][0] != '\0') {
      any = true;
      if (names(argv[i], test.name)) {
        return true;
      }
    }
  }
  return !any && !equal(test.tags, "[.]");
}

}  // namespace

void put_value(double value) {
  uint64_t bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  uint64_t mantissa = bits & ((uint64_t{1} << 52) - 1);
  int exponent = static_cast<int>(bits >> 52 & 0x7FF);
  port::put(bits >> 63 != 0 ? "-" : "");
  if (exponent == 0x7FF) {
    port::put(mantissa == 0 ? "inf" : "nan");
    return;
  }
  if (exponent != 0) {
    mantissa |= uint64_t{1} << 52;
    --exponent;
  }
  exponent -= 1074;
  while (mantissa != 0 && mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  port::print(static_cast<unsigned long long>(mantissa), " * 2^", exponent);
}

void put_value(bool value) {
  port::put(value ? "true" : "false");
}

void put_value(const char* value) {
  if (value == nullptr) {
    port::put("nullptr");
  } else {
    port::print("\"", value, "\"");
  }
}

void put_value(const void* value) {
  port::print("address ", static_cast<unsigned long>(reinterpret_cast<uintptr_t>(value)));
}

Message::Message(const char* name, const AnyValue& value)
    : outer_(innermost), name_(name), value_(value) {
  innermost = this;
}

Message::~Message() {
  innermost = outer_;
}

void put_messages() {
  for (const Message* message = innermost; message != nullptr; message = message->outer_) {
    port::print("  ", message->name_, " := ");
    message->value_.put(message->value_.address);
    port::put("\n");
  }
}

void report(const Site& site, const AnyValue& left, const char* comparison, const AnyValue& right) {
  ++failures;
  port::print(site.file, ":", site.line, ": failed in \"", running, "\"\n  ", site.macro, "( ",
              site.expression, " )\n  with ");
  left.put(left.address);
  if (comparison != nullptr) {
    port::put(comparison);
    right.put(right.address);
  }
  port::put("\n");
  put_messages();
}

TestCase::TestCase(const Description& test) : description(test) {
  (last_case == nullptr ? first_case : last_case->next) = this;
  last_case = this;
}

int run(int argc, char** argv) {
  bool list = false;
  for (int i = 1; i < argc; ++i) {
    if (equal(argv[i], "--list-reporters")) {
      port::put("console\n");
      return 1;
    }
    if (equal(argv[i], "--list-test-names-only")) {
      list = true;
    } else if (argv[i][0] == '-') {
      port::print("unknown option ", argv[i], "\n");
      return kNothingRan;
    }
  }
  int count = 0;
  for (const TestCase* test = first_case; test != nullptr; test = test->next) {
    if (!is_selected(argc, argv, test->description)) {
      continue;
    }
    ++count;
    running = test->description.name;
    port::print(running, "\n");  // identifies the test case if it faults
    if (!list) {
      test->description.function();
    }
  }
  if (list) {
    return count;
  }
  port::print("test cases: ", count, ", failures: ", failures, "\n");
  if (count == 0) {
    return kNothingRan;
  }
  return static_cast<int>(failures < kMostFailures ? failures : kMostFailures);
}

}  // namespace small_catch
