// What the C interface refuses, each with the status that C++ gives.
#include <catch2/catch.hpp>

#include <cstddef>
#include <cstring>
#include <vector>

#include "bake/image_bytes.hpp"
#include "c_api/queries.h"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "support/shapes.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

using Words = std::vector<std::uint32_t>;

template <class Index, Layout layout>
Words any_image(double cell) {
  Random random(5);
  const auto mesh = random_mesh(random, 9, 30, 25);
  auto baked = bake::lay_out<Index, layout>(any_tree(random, mesh), mesh);
  baked.cell = cell;
  return image_of(baked);
}

Words post_image(double cell = 1) {
  return any_image<std::uint16_t, Layout::post_indexed>(cell);
}

/// The status, and whether a refusal leaves the tree alone.
flashbvh_status opened(const void* image, std::size_t size) {
  flashbvh_mesh tree;
  flashbvh_mesh before;
  std::memset(&tree, 0xA5, sizeof tree);
  std::memset(&before, 0xA5, sizeof before);
  const flashbvh_status status = flashbvh_open(image, size, &tree);
  CHECK((std::memcmp(tree.opaque.bytes, before.opaque.bytes, sizeof tree) == 0) ==
        (status != FLASHBVH_STATUS_DONE));
  return status;
}

flashbvh_status opened(const Words& words) {
  return opened(words.data(), words.size() * sizeof words[0]);
}

void repair_crc(Words& words) {
  words[offsetof(ImageHeader, crc) / 4] = image_crc(words.data(), 4 * words.size());
}

flashbvh_mesh tree_in(const Words& words) {
  flashbvh_mesh tree;
  REQUIRE(flashbvh_open(words.data(), 4 * words.size(), &tree) == FLASHBVH_STATUS_DONE);
  return tree;
}

/// Every way to ask, on trees or a pose that belong to no query.
void all_refuse(const flashbvh_mesh& a, const flashbvh_mesh& b, const flashbvh_pose& pose,
                flashbvh_status status) {
  flashbvh_query query;
  flashbvh_pair found[1] = {{1, 2}};
  std::uint32_t count = 99;
  bool yes = false;
  CHECK(flashbvh_query_start(&query, &a, &b, &pose) == status);
  CHECK(flashbvh_query_status(&query) == status);
  CHECK(flashbvh_query_run(&query, 100, found, 1, &count) == status);
  CHECK(count == 0);
  count = 99;
  CHECK(flashbvh_query_run(&query, 100, nullptr, 0, &count) == status);
  CHECK(count == 0);
  CHECK(flashbvh_query_counts(&query).visits == 0);
  const flashbvh_position start = {0, 0, 0, 0, {0, 0, 0}};
  CHECK(flashbvh_query_resume(&query, &start) == status);
  CHECK(flashbvh_intersects(&a, &b, &pose, &yes) == status);
  CHECK(yes);
  yes = false;
  CHECK(flashbvh_first_pair(&a, &b, &pose, &yes, found) == status);
  CHECK((yes && found[0].a == 1 && found[0].b == 2));
  count = 99;
  CHECK(flashbvh_count_pairs(&a, &b, &pose, &count) == status);
  CHECK(count == 0);
  count = 99;
  CHECK(flashbvh_find_pairs(&a, &b, &pose, found, 1, &count) == status);
  CHECK(count == 0);
  const auto visit = [](flashbvh_pair, void* context) {
    *static_cast<bool*>(context) = false;
    return true;
  };
  CHECK(flashbvh_for_each_pair(&a, &b, &pose, visit, &yes) == status);
  CHECK(yes);  // not visited
}

}  // namespace

TEST_CASE("C: each way an image can be no image has its own status") {
  Words words = post_image();
  CHECK(opened(words) == FLASHBVH_STATUS_DONE);
  SECTION("truncated") {
    for (std::size_t size = 0; size < 4 * words.size(); ++size) {
      REQUIRE(opened(words.data(), size) == FLASHBVH_STATUS_IMAGE_TRUNCATED);
    }
  }
  SECTION("misaligned") {
    Words room(words.size() + 1);
    auto* const shifted = reinterpret_cast<unsigned char*>(room.data()) + 2;
    std::memcpy(shifted, words.data(), 4 * words.size());
    CHECK(opened(shifted, 4 * words.size()) == FLASHBVH_STATUS_IMAGE_MISALIGNED);
  }
  SECTION("not flashbvh") {
    words[0] ^= 1;
    CHECK(opened(words) == FLASHBVH_STATUS_IMAGE_NOT_FLASHBVH);
  }
  SECTION("another version") {
    words[1] ^= 2;
    CHECK(opened(words) == FLASHBVH_STATUS_IMAGE_VERSION);
  }
  SECTION("damaged") {
    words[words.size() / 2] ^= 0x1000;
    CHECK(opened(words) == FLASHBVH_STATUS_IMAGE_CORRUPT);
  }
  SECTION("wrong, with the right checksum") {
    words[offsetof(ImageHeader, leaf_count) / 4] += 1;
    repair_crc(words);
    CHECK(opened(words) == FLASHBVH_STATUS_IMAGE_INVALID);
  }
  SECTION("another kind of tree") {
    CHECK(opened(any_image<std::uint16_t, Layout::pre_indexed>(1)) == FLASHBVH_STATUS_IMAGE_KIND);
    CHECK(opened(any_image<std::uint32_t, Layout::post_indexed>(1)) == FLASHBVH_STATUS_IMAGE_KIND);
  }
}

TEST_CASE("C: trees with different cells are refused by every question") {
  const Words one = post_image(0.5);
  const Words other = post_image(0.25);
  flashbvh_pose pose;
  CHECK(flashbvh_pose_translated(0, 0, 0, &pose) == FLASHBVH_STATUS_DONE);
  all_refuse(tree_in(one), tree_in(other), pose, FLASHBVH_STATUS_CELL_MISMATCH);
}

TEST_CASE("C: a pose that can't be is refused by every question, and by what is made of it") {
  const Words words = post_image();
  const flashbvh_mesh tree = tree_in(words);
  const std::int32_t one = FLASHBVH_ROTATION_ONE;
  const std::int32_t origin[3] = {0, 0, 0};
  flashbvh_pose good;
  flashbvh_pose bad;
  flashbvh_pose made;
  CHECK(flashbvh_pose_translated(1, 2, 3, &good) == FLASHBVH_STATUS_DONE);
  flashbvh_status status = FLASHBVH_STATUS_DONE;
  SECTION("too far") {
    status = FLASHBVH_STATUS_TRANSLATION_OUT_OF_RANGE;
    CHECK(flashbvh_pose_translated(0, FLASHBVH_MAX_TRANSLATION + 1, 0, &bad) == status);
  }
  SECTION("scaled") {
    status = FLASHBVH_STATUS_NOT_A_ROTATION;
    const std::int32_t scaled[9] = {one, 0, 0, 0, one, 0, 0, 0, one / 2};
    CHECK(flashbvh_pose_rigid(scaled, origin, nullptr, &bad) == status);
  }
  SECTION("mirrored") {
    status = FLASHBVH_STATUS_NOT_A_ROTATION;
    const std::int32_t mirrored[9] = {one, 0, 0, 0, one, 0, 0, 0, -one};
    CHECK(flashbvh_pose_rigid(mirrored, origin, nullptr, &bad) == status);
  }
  CHECK(flashbvh_pose_status(&bad) == status);
  CHECK(flashbvh_pose_inverse(&bad, &made) == status);
  CHECK(flashbvh_pose_composed(&bad, &good, &made) == status);
  CHECK(flashbvh_pose_composed(&good, &bad, &made) == status);
  CHECK(flashbvh_pose_relative(&good, &bad, &made) == status);
  all_refuse(tree, tree, made, status);
}

TEST_CASE("C: a position of no query is refused and changes nothing") {
  const Words words = post_image();
  const flashbvh_mesh tree = tree_in(words);
  flashbvh_pose pose;
  flashbvh_query query;
  flashbvh_pair found[8];
  std::uint32_t count = 0;
  flashbvh_pose_translated(0, 0, 0, &pose);
  flashbvh_query_start(&query, &tree, &tree, &pose);
  CHECK(flashbvh_query_run(&query, 2, found, 8, &count) == FLASHBVH_STATUS_SUSPENDED);
  const flashbvh_position before = flashbvh_query_position(&query);
  const flashbvh_position wrong[] = {{0xFFFF, 0, 0, 1, {}},
                                     {0, 0xFFFF, 0, 1, {}},
                                     {0, 0, 0, 4, {}},
                                     {0, 0, 0, 0xFF, {}},
                                     {0, 0, 1, 2, {}}};
  for (const flashbvh_position& position : wrong) {
    CHECK(flashbvh_query_resume(&query, &position) == FLASHBVH_STATUS_POSITION_INVALID);
    const flashbvh_position after = flashbvh_query_position(&query);
    CHECK(std::memcmp(&before, &after, sizeof before) == 0);
  }
  CHECK(flashbvh_query_status(&query) == FLASHBVH_STATUS_SUSPENDED);
}

TEST_CASE("C: an array without room is full, and nothing is lost") {
  const Words words = post_image();
  const flashbvh_mesh tree = tree_in(words);
  flashbvh_pose pose;
  flashbvh_query query;
  std::uint32_t count = 99;
  flashbvh_pose_translated(0, 0, 0, &pose);
  flashbvh_query_start(&query, &tree, &tree, &pose);
  CHECK(flashbvh_query_run(&query, 10, nullptr, 0, &count) == FLASHBVH_STATUS_FULL);
  CHECK(count == 0);
  CHECK(flashbvh_query_counts(&query).visits == 0);
  CHECK(flashbvh_query_status(&query) == FLASHBVH_STATUS_SUSPENDED);
}
