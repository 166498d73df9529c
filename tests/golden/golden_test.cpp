// Golden images bake again to equal bytes, open, and answer as recorded, on the host and all cores.
#include "golden/golden.hpp"
#include "flashbvh/image.hpp"
#include "support/test.hpp"

namespace {

const KeptImage* kept_image(const std::string& name) {
  const auto* const end = kKeptImages + kKeptImageCount;
  const auto* const found =
      std::find_if(kKeptImages, end, [&](const KeptImage& kept) { return kept.name == name; });
  return found == end ? nullptr : found;
}

/// The first line, counted from 1, in which two texts differ.
std::size_t line_of_difference(const std::string& text, const std::string& other) {
  const auto end = std::mismatch(text.begin(), text.end(), other.begin(), other.end()).first;
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
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

TEST_CASE("golden images open and answer as they did when they were made") {
  const std::string answers = answers_of(kKeptImages, kKeptImageCount);
  CAPTURE(line_of_difference(answers, kKeptAnswers));
  CHECK(answers == kKeptAnswers);
}
