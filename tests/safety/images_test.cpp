// Flipped bits of images: every one is refused, and so are two at once.
#include <iostream>
#include <map>

#include "flashbvh/image.hpp"
#include "flashbvh/robot/image.hpp"
#include "robot/known_robot.hpp"
#include "safety/flips.hpp"
#include "self_test/known_mesh.hpp"
#include "support/test.hpp"

namespace {

/// The number of flips that ended with each status.
using Counts = std::map<Status, std::uint32_t>;

void print(const char* title, const Counts& counts) {
  std::cout << title;
  for (const auto& [status, count] : counts) {
    std::cout << ", " << status_name(status) << ' ' << count;
  }
  std::cout << '\n';
}

/// `open(words, size)`: the status of the image with these words, of `size` bytes.
template <std::size_t count, class Open>
void check_flips(const char* name, const std::uint32_t (&image)[count], const Open& open) {
  std::vector<std::uint32_t> words(std::begin(image), std::end(image));
  REQUIRE(open(words.data(), sizeof image) == Status::done);
  Counts single;
  (void)count_flips(words.data(), sizeof image, [&] {
    ++single[open(words.data(), sizeof image)];
    return false;
  });
  print(name, single);
  CHECK(single.count(Status::done) == 0);

  Random random(test_seed());
  Counts pairs;
  for (int i = 0; i < 100'000; ++i) {
    const std::uint32_t bits = 32 * count;
    const std::uint32_t first = random.below(bits);
    const std::uint32_t second = (first + 1 + random.below(bits - 1)) % bits;
    words[first / 32] ^= 1u << first % 32;
    words[second / 32] ^= 1u << second % 32;
    ++pairs[open(words.data(), sizeof image)];
    words.assign(std::begin(image), std::end(image));
  }
  print("  100,000 random pairs of bits", pairs);
  CHECK(pairs.count(Status::done) == 0);
}

}  // namespace

TEST_CASE("each flipped bit of an image is refused, and each of 100,000 pairs of bits") {
  Mesh meshes[2];
  check_flips(
      "each bit of a mesh's image", detail::kKnownMesh,
      [&](const void* words, std::size_t size) { return open_image(words, size, *meshes); });
  Robot robot{};
  check_flips("each bit of a robot's image", detail::kKnownRobot,
              [&](const void* words, std::size_t size) {
                return open_robot(words, size, meshes, 2, robot);
              });
}
