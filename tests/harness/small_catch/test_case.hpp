// Test cases: a list that static objects make of themselves before main(), and how it is run.
#ifndef FLASHBVH_SMALL_CATCH_TEST_CASE_HPP
#define FLASHBVH_SMALL_CATCH_TEST_CASE_HPP

namespace small_catch {

/// Lies in flash.
struct Description {
  const char* name;
  const char* tags;
  void (*function)();
};

/// 8 bytes of RAM a test case on a 32-bit core.
class TestCase {
 public:
  explicit TestCase(const Description& description);

  const Description& description() const { return description_; }
  /// In the order of the sources; null after the last one.
  static const TestCase* first();
  const TestCase* next() const { return next_; }

 private:
  const Description& description_;
  const TestCase* next_ = nullptr;
};

/// The name of the test case that runs.
const char* running_test();

/// What Catch2's main() does, as far as CTest needs it:
///   program                           runs all test cases but those that a tag `[.]` hides
///   program NAME... or TAG...         runs those, hidden or not; `\` takes the next character of a
///                                     name as it stands
///   program --list-test-names-only    lists them; returns their number
///   program --list-reporters          for Catch.cmake
/// Returns the number of failures, at most 100, below the statuses of ports/run. That nothing
/// matches is a failure.
int run(int argc, char** argv);

}  // namespace small_catch

#endif
