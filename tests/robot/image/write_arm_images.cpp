// write_arm_images FOLDER: writes the images that are kept, for a new version of the format, or
// when bake builds other trees on purpose:
//     build/native/bin/write_arm_images tests/fuzz/corpus/robot
#include <cstdlib>
#include <fstream>

#include "support/arms/arm_images.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  for (const flashbvh::test::NamedImage& image : flashbvh::test::arm_images()) {
    std::ofstream(argv[1] + ("/" + image.name) + ".robot", std::ios::binary)
        .write(reinterpret_cast<const char*>(image.words.data()),
               static_cast<std::streamsize>(image.words.size() * sizeof image.words[0]));
  }
  return EXIT_SUCCESS;
}
