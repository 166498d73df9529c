// Regions of memory, checked in slices.
#include <catch2/catch.hpp>

#include <initializer_list>

#include "flashbvh/memory_region.hpp"

using namespace flashbvh;

namespace {

constexpr size_t kAll = static_cast<size_t>(-1);

uint8_t memory[3][37];

/// Regions of the current memory.
struct Regions {
  Regions() {
    for (auto& bytes : memory) {
      for (uint8_t& byte : bytes) {
        byte = static_cast<uint8_t>(7 * (&byte - memory[0]) + 1);
      }
    }
    const size_t sizes[3] = {sizeof memory[0], 0, 20};
    for (int i = 0; i < 3; ++i) {
      list[i] = region_of(memory[i], sizes[i]);
    }
  }
  MemoryRegion list[3];
};

}  // namespace

TEST_CASE("regions that hold are done after their bytes, again and again, whatever the slices") {
  const Regions regions;
  for (const size_t slice : {size_t{1}, size_t{5}, size_t{37}, size_t{56}, size_t{57}, kAll}) {
    RegionTest test(regions.list, 3);
    for (int round = 0; round < 3; ++round) {
      CAPTURE(slice, round);
      size_t runs = 1;
      Status status = test.run(slice);
      CHECK(test.run(0) == (status == Status::done && slice != 0 ? Status::suspended : status));
      for (; status == Status::suspended; ++runs) {
        status = test.run(slice);
      }
      CHECK(status == Status::done);
      CHECK(runs == (slice < 57 ? (57 + slice - 1) / slice : 1));
    }
  }
  CHECK(RegionTest(regions.list, 0).run(1) == Status::done);
}

TEST_CASE("each flipped bit of a region or of its description is found, and stays found") {
  Regions regions;
  const auto fails_at = [&](uint32_t region) {
    RegionTest test(regions.list, 3);
    return test.run(kAll) == Status::self_test_failed && test.region() == region &&
           test.run(1) == Status::self_test_failed && test.region() == region;
  };
  for (uint32_t bit = 0; bit < 8 * 20; ++bit) {
    memory[2][bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
    REQUIRE(fails_at(2));
    memory[2][bit / 8] ^= static_cast<uint8_t>(1u << bit % 8);
  }
  for (int i = 0; i < 3; ++i) {
    for (uint32_t bit = 0; bit < 32; ++bit) {
      regions.list[i].crc ^= 1u << bit;
      REQUIRE(fails_at(static_cast<uint32_t>(i)));
      regions.list[i].crc ^= 1u << bit;
    }
  }
  for (const size_t size : {36u, 33u, 5u, 0u}) {
    regions.list[0].size = size;
    REQUIRE(fails_at(0));
  }
}

TEST_CASE("a region that shrinks while it is checked is found, and not read beyond") {
  Regions regions;
  RegionTest test(regions.list, 3);
  REQUIRE(test.run(30) == Status::suspended);
  regions.list[0].size = 8;
  CHECK(test.run(1) == Status::self_test_failed);
  CHECK(test.region() == 0);
}
