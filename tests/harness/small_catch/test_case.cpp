#include "test_case.hpp"

#include "assertion.hpp"
#include "path.hpp"

namespace small_catch {
namespace {

constexpr unsigned kMostFailures = 100;
constexpr int kNothingRan = 101;

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

bool starts(const char* text, const char* with) {
  while (*with != '\0' && *text == *with) {
    ++text;
    ++with;
  }
  return *with == '\0';
}

bool contains(const char* text, const char* part) {
  while (*text != '\0' && !starts(text, part)) {
    ++text;
  }
  return *text != '\0';
}

/// Whether an argument is this name, once its backslashes are taken out.
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

bool selects(const char* argument, const Description& test) {
  return *argument == '[' ? contains(test.tags, argument) : names(argument, test.name);
}

bool is_hidden(const Description& test) {
  return contains(test.tags, "[.");
}

bool is_selected(int argc, char** argv, const Description& test) {
  bool any = false;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] == '-' || argv[i][0] == '\0') {
      continue;
    }
    if (selects(argv[i], test)) {
      return true;
    }
    any = true;
  }
  return !any && !is_hidden(test);
}

void run_all_paths(const Description& test) {
  running = test.name;
  port::print(running, "\n");  // the last one before a fault
  first_path();
  do {
    test.function();
  } while (next_path());
}

}  // namespace

TestCase::TestCase(const Description& description) : description_(description) {
  if (last_case == nullptr) {
    first_case = this;
  } else {
    last_case->next_ = this;
  }
  last_case = this;
}

const TestCase* TestCase::first() {
  return first_case;
}

const char* running_test() {
  return running;
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
  for (const TestCase* test = TestCase::first(); test != nullptr; test = test->next()) {
    const Description& description = test->description();
    if (!is_selected(argc, argv, description)) {
      continue;
    }
    ++count;
    if (list) {
      port::print(description.name, "\n");
    } else {
      run_all_paths(description);
    }
  }
  if (list) {
    return count;
  }
  port::print("test cases: ", count, ", failures: ", failures(), "\n");
  if (count == 0) {
    return kNothingRan;
  }
  return static_cast<int>(failures() < kMostFailures ? failures() : kMostFailures);
}

}  // namespace small_catch
