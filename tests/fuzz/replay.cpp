// PROGRAM PATH...: replaces libFuzzer's first pass: runs each file, and every file of each folder,
// then its truncated copies and copies with some bytes changed, always in the same way.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "fuzz/fuzz.hpp"
#include "support/random.hpp"

namespace {

constexpr int kChanged = 60;  // copies of a file

void run(const std::vector<std::uint8_t>& bytes) {
  // A separate block, so that the address sanitizer detects each access after it.
  const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[bytes.size()]);
  std::copy(bytes.begin(), bytes.end(), exact.get());
  (void)LLVMFuzzerTestOneInput(exact.get(), bytes.size());
}

void run_changed(std::vector<std::uint8_t> bytes, flashbvh::test::Random& random) {
  if (bytes.empty()) {
    return;
  }
  if (random.below(4) == 0) {
    bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
  }
  for (std::uint32_t i = random.below(4); i != 0 && !bytes.empty(); --i) {
    std::uint8_t& byte = bytes[random.below(static_cast<std::uint32_t>(bytes.size()))];
    byte = static_cast<std::uint8_t>(random.below(2) == 0 ? random.next()
                                                          : byte ^ (1u << random.below(8)));
  }
  run(bytes);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    if (!std::filesystem::is_directory(argv[i])) {
      files.emplace_back(argv[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  flashbvh::test::Random random(flashbvh::test::test_seed());
  for (const auto& path : files) {
    std::printf("%s\n", path.filename().c_str());
    std::fflush(stdout);
    std::ifstream file(path, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file),
                                          std::istreambuf_iterator<char>()};
    run(bytes);
    for (int i = 0; i < kChanged; ++i) {
      run_changed(bytes, random);
    }
  }
  return files.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
