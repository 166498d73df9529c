// main() of every test program on a board: runs all test cases. Its status is the number of
// failures, at most 100, below the statuses of ports/run.
#include "catch2/catch.hpp"
#include "semihosting.hpp"
#include "stack.hpp"
#include "text.hpp"

namespace board_catch {
namespace {

constexpr int kMostFailures = 100;

int failures = 0;
const Message* innermost = nullptr;
TestCase* first_case = nullptr;
TestCase* last_case = nullptr;
const char* running = "";

/// Runs all test cases; returns their number.
int run_all() {
  int count = 0;
  for (const TestCase* test = first_case; test != nullptr; test = test->next) {
    running = test->name;
    port::print(running, "\n");  // identifies the test case if it faults
    test->function();
    ++count;
  }
  return count;
}

}  // namespace

TestCase::TestCase(const char* title, void (*body)()) : name(title), function(body) {
  (last_case == nullptr ? first_case : last_case->next) = this;
  last_case = this;
}

Value::Value(double value) {
  static_assert(sizeof number == sizeof value);
  __builtin_memcpy(&number, &value, sizeof number);
}

Message::Message(const char* names, const Value* values, size_t count)
    : outer_(innermost), names_(names), values_(values), count_(count) {
  innermost = this;
}

Message::~Message() {
  innermost = outer_;
}

void Message::print_all() {
  for (const Message* message = innermost; message != nullptr; message = message->outer_) {
    port::print("  ", message->names_, " :=");
    for (size_t i = 0; i < message->count_; ++i) {
      const Value& value = message->values_[i];
      port::put(" ");
      if (value.text != nullptr) {
        port::put(value.text);
      } else {
        port::put(value.number);
      }
    }
    port::put("\n");
  }
}

bool check(bool holds, const char* text, const char* file, int line) {
  if (!holds) {
    ++failures;
    port::print(file, ":", line, ": failed in \"", running, "\"\n  ", text, "\n");
    Message::print_all();
  }
  return holds;
}

void require(bool holds, const char* text, const char* file, int line) {
  if (!check(holds, text, file, line)) {
    port::exit_program(1);
  }
}

}  // namespace board_catch

int main() {
  const int count = board_catch::run_all();
  const int failures = board_catch::failures;
  port::print("test cases: ", count, ", failures: ", failures, "\n");
  // Few boards fault when the stack overflows. The last words may never have been written: a frame
  // need not fill itself.
  if (port::stack_used() == port::stack_size()) {
    port::put("the stack overflowed\n");
    return 1;
  }
  return count == 0                              ? 1
         : failures < board_catch::kMostFailures ? failures
                                                 : board_catch::kMostFailures;
}
