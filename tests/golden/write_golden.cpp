// write_golden FOLDER: writes the golden images and their answers. For a new version of the format,
// or when bake builds other trees on purpose:
//     build/native/bin/write_golden tests/golden
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "golden/golden.hpp"

using namespace flashbvh::test;

int main(int argc, char** argv) {
  if (argc != 2) {
    return EXIT_FAILURE;
  }
  const std::string folder = std::string(argv[1]) + "/";
  std::vector<BakedImage> images = bake_golden_images();
  std::sort(images.begin(), images.end(),
            [](const BakedImage& a, const BakedImage& b) { return a.name < b.name; });
  std::vector<KeptImage> kept;
  for (const BakedImage& image : images) {
    const std::size_t size = image.words.size() * sizeof image.words[0];
    const auto* const bytes = reinterpret_cast<const unsigned char*>(image.words.data());
    kept.push_back({image.name.c_str(), bytes, size});
    std::ofstream(folder + image.name + ".fbvh", std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }
  std::ofstream(folder + "answers.txt", std::ios::binary) << answers_of(kept.data(), kept.size());
  return EXIT_SUCCESS;
}
