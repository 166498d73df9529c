// write_golden FOLDER: writes the golden images. For a new version of the format, or when bake
// builds other trees on purpose:
//     build/native/bin/write_golden tests/golden
#include <cstdlib>
#include <fstream>

#include "golden/golden.hpp"

using namespace flashbvh::test;

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  const std::string folder = std::string(argv[1]) + "/";
  for (const BakedImage& image : bake_golden_images()) {
    const std::size_t size = image.words.size() * sizeof image.words[0];
    const auto* const bytes = reinterpret_cast<const unsigned char*>(image.words.data());
    std::ofstream(folder + image.name + ".fbvh", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }
  return EXIT_SUCCESS;
}
