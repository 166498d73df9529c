// Test cases of every kind, some of which fail on purpose, compiled with Catch2 and with the small
// header: compare.py holds the two to the same paths and the same verdicts.
#include <catch2/catch.hpp>
#include <cstdio>
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

TEST_CASE("one section after the other") {
  trace("start");
  SECTION("a") {
    trace("a");
  }
  trace("between");
  SECTION("b") {
    trace("b");
  }
  trace("end");
}

TEST_CASE("sections in sections", "[nested]") {
  SECTION("a") {
    trace("a");
    SECTION("a1") {
      trace("a1");
    }
    SECTION("a2") {
      trace("a2");
      SECTION("a2x") {
        trace("a2x");
      }
      SECTION("a2y") {
        trace("a2y");
      }
    }
    trace("end of a");
  }
  SECTION("b") {
    trace("b");
  }
  SECTION("c") {
    trace("c");
    SECTION("c1") {
      trace("c1");
    }
  }
  trace("end");
}

TEST_CASE("sections after values", "[nested][values]") {
  const int value = GENERATE(3, 1, 2);
  const int other = GENERATE(10, 20);
  std::printf("trace: %d %d\n", value, other);
  SECTION("a") {
    trace("a");
  }
  SECTION("b") {
    trace("b");
  }
}

TEST_CASE("values in a section") {
  SECTION("a") {
    const int value = GENERATE(1, 2);
    std::printf("trace: a %d\n", value);
  }
  SECTION("b") {
    trace("b");
  }
}

TEST_CASE("a section only in one run") {
  static int runs = 0;
  ++runs;
  SECTION("a") {
    trace("a");
    CHECK(runs == 1);
  }
  SECTION("b") {
    trace("b");
    CHECK(runs == 2);
  }
  REQUIRE(runs < 3);
}

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

TEST_CASE("a failed CHECK goes on") {
  CHECK(answer() == 41);
  trace("after it");
}

TEST_CASE("a failed CHECK_FALSE goes on") {
  CHECK_FALSE(answer() == 42);
  trace("after it");
}

TEST_CASE("a failed REQUIRE stops") {
  REQUIRE(answer() == 41);
  trace("after it");
}

TEST_CASE("a failed REQUIRE_FALSE stops") {
  REQUIRE_FALSE(answer() == 42);
  trace("after it");
}

TEST_CASE("FAIL stops") {
  FAIL("on purpose");
  trace("after it");
}

TEST_CASE("a failure in the second of three sections") {
  SECTION("a") {
    trace("a");
  }
  SECTION("b") {
    trace("b");
    CHECK(answer() == 1);
  }
  SECTION("c") {
    trace("c");
  }
}

TEST_CASE("values print", "[.][print]") {
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
  CHECK('a' == 'b');
  CHECK(Opaque{1} == Opaque{2});
  CHECK(1.5 == 2.0);
  CHECK(0.5f == -0.1f);
  CHECK(1e30 < 3e-20);
  CHECK(-1.0 / 3 == 1e18);
}

TEST_CASE("messages print", "[.][print]") {
  INFO("about all");
  for (const int round : {1, 2}) {
    const Opaque opaque{round};
    CAPTURE(round, round + 5, "letters", opaque);
    SECTION("in a section") {
      INFO("about a section");
      CHECK(round == 1);
    }
    CHECK(round == 3);
  }
  CHECK(answer() == 0);
}
