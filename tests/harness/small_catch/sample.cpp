// Test cases of every kind, some of which fail on purpose, compiled with Catch2 and with the small
// header; compare.py requires equal verdicts.
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>

namespace {

void trace(const char* step) {
  std::printf("trace: %s\n", step);
}

enum class Colour : unsigned char { red, green };

struct Opaque {
  int value;
  bool operator==(const Opaque& other) const { return value == other.value; }
};

int answer() {
  return 42;
}

}  // namespace

TEMPLATE_TEST_CASE("types", "[types]", char, unsigned short, long) {
  std::printf("trace: %d\n", static_cast<int>(sizeof(TestType)));
  CHECK(sizeof(TestType) > 0);
}

TEMPLATE_TEST_CASE_SIG("numbers", "", ((int number), number), 7, 9) {
  std::printf("trace: %d\n", number);
  CHECK(number > 6);
}

TEST_CASE("a name with blanks, commas, [brackets] and \"quotes\"::of <any> kind") {
  trace("here");
  CHECK(answer() == 42);
}

TEST_CASE("what holds passes") {
  const char* const nothing = nullptr;
  CHECK(answer() == 42);
  CHECK(answer() != 41);
  CHECK(answer() < 43);
  CHECK(answer() <= 42);
  CHECK(answer() > 41L);
  CHECK(answer() >= 42);
  CHECK_FALSE(answer() == 41);
  CHECK((answer() == 42 && answer() != 41));
  CHECK(nothing == nullptr);
  CHECK(Opaque{1} == Opaque{1});
  CHECK(answer());
  REQUIRE_FALSE(nothing != nullptr);
  trace("end");
}

#define FLASHBVH_FAILS(name, ...) \
  TEST_CASE(name) {               \
    __VA_ARGS__;                  \
    trace("after it");            \
  }
FLASHBVH_FAILS("a failed CHECK goes on", CHECK(answer() == 41))
FLASHBVH_FAILS("a failed CHECK_FALSE goes on", CHECK_FALSE(answer() == 42))
FLASHBVH_FAILS("a failed REQUIRE stops", REQUIRE(answer() == 41))
FLASHBVH_FAILS("a failed REQUIRE_FALSE stops", REQUIRE_FALSE(answer() == 42))
FLASHBVH_FAILS("FAIL stops", FAIL("on purpose"))

TEST_CASE("values print", "[.]") {
  const long long large = -9000000000000000000LL;
  const unsigned char small = 200;
  const char* const text = "text";
  const void* const place = reinterpret_cast<const void*>(0x1234);
  const bool truth = false;
  CHECK(large == 9000000000000000000ULL);
  CHECK(small == 201);
  CHECK(text == nullptr);
  CHECK(place == nullptr);
  CHECK(truth == true);
  CHECK(truth);
  CHECK(Colour::red == Colour::green);
  CHECK(Opaque{1} == Opaque{2});
  CHECK(1.5 == -2.0);
  CHECK(0.5f == 0.0f);
}

TEST_CASE("messages print", "[.]") {
  INFO("about all");
  for (const int round : {1, 2}) {
    const Opaque opaque{round};
    CAPTURE(round, round + 5, "letters", opaque);
    CHECK(round == 3);
  }
  CHECK(answer() == 0);
}

#ifdef FLASHBVH_SMALL_CATCH
void small_catch::stop() {
  std::exit(120);  // as on a board
}

int main(int argc, char** argv) {
  return small_catch::run(argc, argv);
}
#endif
