// Golden images bake again to equal bytes.
#include "golden/golden.hpp"

#include <fstream>

#include "support/test.hpp"

namespace {

const KeptImage* kept_image(const std::string& name) {
  const auto* const end = kKeptImages + kKeptImageCount;
  const auto* const found =
      std::find_if(kKeptImages, end, [&](const KeptImage& kept) { return kept.name == name; });
  return found == end ? nullptr : found;
}

}  // namespace

TEST_CASE("golden images are baked again to the byte") {
  const std::vector<BakedImage> images = bake_golden_images();
  CHECK(images.size() == kKeptImageCount);
  for (const BakedImage& image : images) {
    CAPTURE(image.name);
    const KeptImage* const kept = kept_image(image.name);
    REQUIRE(kept != nullptr);
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
