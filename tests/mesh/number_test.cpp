// Numbers in texts: the nearest double in every format, and nothing that is no number.
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "mesh/any_format.hpp"
#include "support/random.hpp"

using namespace flashbvh;
using namespace flashbvh::test;
using tool::FileMesh;

namespace {

double first_coordinate(const TextFormat& format, const std::string& word) {
  return format.read(format.before + "  " + word + "\t1 2\n" + format.after, "file")
      .mesh.vertices.at(0)[0];
}

/// To the sign of zero. The C library's conversion is another one, and rounds to nearest.
bool reads_as(const TextFormat& format, const std::string& word, double wanted) {
  const double found = first_coordinate(format, word);
  return std::memcmp(&found, &wanted, sizeof found) == 0;
}

}  // namespace

TEST_CASE("a number of a text is the nearest double, in every format") {
  const std::vector<std::string> words = {
      "0.1", "-0", "0", ".5", "5.", "+.5", "-.5", "1e3", "1E+3", "5.e-1", "0.3", "1000000.03",
      "5000000.3", "0.1000000000000000055511151231257827", "123456789012345678901234567890",
      "18446744073709551616", "18446744073709551617", "36893488147419103232",
      "00000000000000000000000000000000000001.5",
      // Halfway between two doubles, and a little to either side.
      "9007199254740993", "9007199254740995", "9007199254740992.99999999999999999999",
      "9007199254740993.00000000000000000001", "1.00000000000000011102230246251565404",
      "1.00000000000000011102230246251565405", "1.00000000000000011102230246251565403",
      // Subnormal, below half of the least one, too small for any, as large as a float.
      "4.9e-324", "1e-310", "2.2250738585072011e-308", "2.5e-324", "2.4e-324", "1e-400", "-1e-999",
      "3.4028234663852886e38", "-340282346638528859811704183484516925440"};
  for (const TextFormat& format : kTextFormats) {
    for (const std::string& word : words) {
      CAPTURE(format.name, word);
      CHECK(reads_as(format, word, std::strtod(word.c_str(), nullptr)));
    }
  }
}

TEST_CASE("any number of up to 25 digits is the nearest double, in every format") {
  Random random(test_seed());
  for (int i = 0; i < 3000; ++i) {
    std::string word = random.below(2) == 0 ? "-" : "";
    const std::uint32_t digits = 1 + random.below(25);
    const std::uint32_t point = random.below(digits + 1);
    for (std::uint32_t digit = 0; digit < digits; ++digit) {
      word += (digit == point ? "." : "") + std::to_string(random.below(10));
    }
    if (random.below(3) == 0) {
      word += "e" + std::to_string(static_cast<int>(random.below(340)) - 327);
    }
    const double wanted = std::strtod(word.c_str(), nullptr);
    if (!tool::is_coordinate(wanted)) {
      continue;
    }
    for (const TextFormat& format : kTextFormats) {
      CAPTURE(format.name, word);
      REQUIRE(reads_as(format, word, wanted));
    }
  }
}

TEST_CASE("what is no number, or none that a float can hold, is no coordinate in any format") {
  const std::vector<std::string> words = {
      "nan",   "-nan", "inf",  "INF", "infinity", "0x10",  "0x1p3", "1e39", "-1e39",   "3.5e38",
      "1e999", "1,5",  "1.5f", "1d3", "--1",      "+-1",   "-+1",   "++1",  "+",       "-",
      ".",     "e5",   "1e",   "1e+", "1.2.3",    "1_000", "1/2",   "x",    "\xD9\xA1"};
  for (const TextFormat& format : kTextFormats) {
    for (const std::string& word : words) {
      CAPTURE(format.name, word);
      CHECK(refusal(format.read, format.before + word + " 1 2\n" + format.after) != "");
    }
  }
}

TEST_CASE("line ends, blanks and comments change nothing") {
  for (const TextFormat& format : kTextFormats) {
    CAPTURE(format.name);
    const std::string plain = format.before + "0.1 0.2 0.3\n" + format.after;
    const FileMesh wanted = format.read(plain, "file");
    for (const std::string end : {"\r\n", "\r", " \t\n"}) {
      std::string changed;
      for (const char c : plain) {
        changed += c == '\n' ? end : c == ' ' ? "\t " : std::string(1, c);
      }
      const FileMesh found = format.read(changed, "file");
      CHECK(found.mesh.vertices == wanted.mesh.vertices);
      CHECK(found.mesh.triangles == wanted.mesh.triangles);
    }
  }
  const std::string comments = "# a\n\nv 0.1 0 0 # b\n#v 9 9 9\n\nv 1 0 0\nv 0 1 0\nf 1 2 3#\n";
  CHECK(tool::read_obj(comments, "file").mesh.vertices.size() == 3);
}
