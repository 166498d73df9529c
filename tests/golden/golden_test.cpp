// Golden images bake again to equal bytes.
#include "golden/golden.hpp"

#include <fstream>

#include "support/test.hpp"

TEST_CASE("golden images are baked again to the byte") {
  const std::vector<BakedImage> images = bake_golden_images();
  CHECK(images.size() == kKeptImageCount);
  for (const BakedImage& image : images) {
    CAPTURE(image.name);
    const KeptImage* const end = kKeptImages + kKeptImageCount;
    const KeptImage* const kept =
        std::find_if(kKeptImages, end, [&](const KeptImage& of) { return of.name == image.name; });
    REQUIRE(kept != end);
    REQUIRE(kept->size == image.words.size() * sizeof image.words[0]);
    CHECK(std::memcmp(kept->bytes, image.words.data(), kept->size) == 0);
  }
}

// golden_test "write golden images", for a new version of the format, or when bake builds other
// trees on purpose.
TEST_CASE("write golden images", "[.]") {
  for (const BakedImage& image : bake_golden_images()) {
    std::ofstream("tests/golden/" + image.name + ".fbvh", std::ios::binary)
        .write(reinterpret_cast<const char*>(image.words.data()),
               static_cast<std::streamsize>(image.words.size() * sizeof image.words[0]));
  }
}
