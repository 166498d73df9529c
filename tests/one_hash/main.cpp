// one_hash    prints the hash of kQueries queries and kPeriods periods; exits with 0 if it is the
//             hash of every core and every language
// one_hash QUERIES PERIODS FOLDER    prints the hash of these counts; writes the input of answers.*
//             to FOLDER: images, poses and joint values
#include "sequence.hpp"
#include "support/print.hpp"

#if !defined(FLASHBVH_ON_BOARD)
#include <cstdlib>
#include <fstream>
#include <string>
#endif

using namespace one_hash;
using flashbvh::test::Hexadecimal;
using flashbvh::test::print;

namespace {

constexpr uint32_t kQueries = 10000;
constexpr uint32_t kPeriods = 10000;
constexpr uint32_t kExpected = 0x817875E7;

#if !defined(FLASHBVH_ON_BOARD)
class Output {
 public:
  explicit Output(const std::string& path) : file_(path, std::ios::binary) {}
  template <class Data>
  void write(const Data* data, std::size_t bytes) {
    file_.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  }
  bool is_good() {
    file_.flush();
    return file_.good();
  }

 private:
  std::ofstream file_;
};

template <class Inputs>
bool write_inputs(const std::string& path, std::uint32_t count) {
  Output output(path);
  Inputs inputs;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto floats = inputs.next();
    output.write(&floats, sizeof floats);
  }
  return output.is_good();
}

int write_and_print(std::uint32_t queries, std::uint32_t periods, const std::string& folder) {
  bool is_good = write_inputs<Poses>(folder + "/poses", queries) &&
                 write_inputs<Trajectory>(folder + "/values", periods);
  for (const Image& image : kImage) {
    Output output(folder + "/" + image.name);
    output.write(image.words, image.bytes);
    is_good = is_good && output.is_good();
  }
  print(Hexadecimal(hash_of(queries, periods)).text, "\n");
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
