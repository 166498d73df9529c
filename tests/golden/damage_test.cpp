// Golden images truncated, and small ones with each single bit changed: refused; with a repaired
// checksum, refused or harmless.
#include "flashbvh/image.hpp"
#include "golden/exercise.hpp"
#include "golden/golden.hpp"
#include "support/test.hpp"

namespace {

bool opens(const void* bytes, std::size_t size) {
  return exercise_image(bytes, size, {}).opened;
}

std::vector<unsigned char> bytes_of(const KeptImage& image) {
  return {image.bytes, image.bytes + image.size};
}

void flip(std::vector<unsigned char>& bytes, std::size_t bit) {
  bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << (bit % 8)));
}

/// A small image has every part; each of its bits is tested.
bool is_small(const KeptImage& image) {
  return image.size < 1000;
}

}  // namespace

TEST_CASE("golden images open, and queries on them are harmless") {
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    CAPTURE(kKeptImages[i].name);
    const test::Verdict verdict =
        exercise_image(kKeptImages[i].bytes, kKeptImages[i].size, representative_poses());
    CHECK(verdict.opened);
    CHECK(verdict.wrong == nullptr);
  }
}

TEST_CASE(
    "a golden image that lost its end is refused, at every length, its size repaired or not") {
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    CAPTURE(kKeptImages[i].name);
    const std::vector<unsigned char> whole = bytes_of(kKeptImages[i]);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      REQUIRE_FALSE(opens(whole.data(), size));
    }
    for (std::size_t size = sizeof(ImageHeader); size < whole.size(); ++size) {
      std::vector<unsigned char> cut(whole.data(), whole.data() + size);
      const auto byte_count = static_cast<std::uint32_t>(size);
      std::memcpy(&cut[offsetof(ImageHeader, byte_count)], &byte_count, sizeof byte_count);
      repair_crc(cut.data(), cut.size());
      REQUIRE_FALSE(opens(cut.data(), cut.size()));
    }
  }
}

TEST_CASE("a golden image with bytes after its end is itself") {
  std::vector<unsigned char> bytes = bytes_of(kKeptImages[0]);
  bytes.push_back(255);
  CHECK(opens(bytes.data(), bytes.size()));
}

TEST_CASE("every flipped bit of a small golden image is refused") {
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    CAPTURE(kKeptImages[i].name);
    std::vector<unsigned char> bytes = bytes_of(kKeptImages[i]);
    for (std::size_t bit = 0; bit < 8 * bytes.size() && is_small(kKeptImages[i]); ++bit) {
      flip(bytes, bit);
      REQUIRE_FALSE(opens(bytes.data(), bytes.size()));
      flip(bytes, bit);
    }
  }
}

TEST_CASE("two flipped bits of a golden image are refused") {
  Random random(test_seed());
  std::vector<unsigned char> bytes = bytes_of(kKeptImages[0]);
  const auto bits = static_cast<std::uint32_t>(8 * bytes.size());
  for (int i = 0; i < 100'000; ++i) {
    const std::uint32_t first = random.below(bits);
    const std::uint32_t second = (first + 1 + random.below(bits - 1)) % bits;
    flip(bytes, first);
    flip(bytes, second);
    REQUIRE_FALSE(opens(bytes.data(), bytes.size()));
    flip(bytes, second);
    flip(bytes, first);
  }
}

TEST_CASE("every flipped bit of a small golden image with a checksum that matches is harmless") {
  const std::vector<Pose> poses = representative_poses();
  std::size_t opened = 0;
  for (std::size_t i = 0; i < kKeptImageCount; ++i) {
    CAPTURE(kKeptImages[i].name);
    std::vector<unsigned char> bytes = bytes_of(kKeptImages[i]);
    for (std::size_t bit = 0; bit < 8 * bytes.size() && is_small(kKeptImages[i]); ++bit) {
      CAPTURE(bit);
      flip(bytes, bit);
      repair_crc(bytes.data(), bytes.size());
      const test::Verdict verdict = exercise_image(bytes.data(), bytes.size(), poses);
      REQUIRE(verdict.wrong == nullptr);
      opened += verdict.opened ? 1 : 0;
      flip(bytes, bit);
    }
  }
  CHECK(opened > 0);  // a changed id, origin, or coordinate inside its box can be valid
}
