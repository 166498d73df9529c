// one_hash    prints the hash of kQueries queries and kPeriods periods; exits with 0 if it is the
//             hash of every core and every language
// one_hash QUERIES PERIODS FOLDER    prints the hash of these counts, of the kinds of queries that
//             Python has; writes the input of answers.py to FOLDER: images, poses and joint values
#include "sequence.hpp"
#include "support/print.hpp"

#if !defined(FLASHBVH_ON_BOARD)
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>
#endif

using namespace one_hash;
using flashbvh::test::Hexadecimal;
using flashbvh::test::print;

namespace {

constexpr uint32_t kQueries = 10000;
constexpr uint32_t kPeriods = 10000;
constexpr uint32_t kExpected = 0x817875E7;

#if !defined(FLASHBVH_ON_BOARD)
bool write(const std::string& path, const void* data, std::size_t bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  return file.flush().good();
}

template <class Inputs>
bool write_inputs(const std::string& path, std::uint32_t count) {
  Inputs inputs;
  std::vector<decltype(inputs.next())> all(count);
  std::generate(all.begin(), all.end(), [&] { return inputs.next(); });
  return write(path, all.data(), count * sizeof all[0]);
}

int write_and_print(std::uint32_t queries, std::uint32_t periods, const std::string& folder) {
  bool is_good = write_inputs<Poses>(folder + "/poses", queries) &&
                 write_inputs<Trajectory>(folder + "/values", periods);
  for (const Image& image : kImage) {
    is_good = is_good && write(folder + "/" + image.name, image.words, image.bytes);
  }
  print(Hexadecimal(hash_of(queries, periods, kKindsOfPython)).text, "\n");
  return is_good ? 0 : 2;
}
#endif

}  // namespace

#if defined(FLASHBVH_ON_BOARD)
int main() {
#else
int main(int argc, char** argv) {
  if (argc == 4) {
    const auto number = [](const char* text) {
      return static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
    };
    return write_and_print(number(argv[1]), number(argv[2]), argv[3]);
  }
#endif
  const uint32_t hash = hash_of(kQueries, kPeriods);
  print(kQueries, " queries and ", kPeriods, " periods: ", Hexadecimal(hash).text, "\n");
  if (hash != kExpected) {
    print("expected: ", Hexadecimal(kExpected).text, "\n");
  }
  return hash == kExpected ? 0 : 1;
}
