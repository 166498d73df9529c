// The stack that the calls of the C interface take, painted and measured on the target.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/image_bytes.hpp"
#include "c_api/queries.h"
#include "stack.hpp"
#include "support/torus.hpp"

using namespace flashbvh;

namespace {

/// A run's stack is that of a query in C++ and the frame of the call; a question in one call has
/// the query itself, too. The figures stand in flashbvh.h.
constexpr std::uint32_t kMostOfRun = 304;
constexpr std::uint32_t kMostOfQuestion = 432;
constexpr std::uint32_t kMostOfOpen = 480;

flashbvh_pose turned() {
  const std::int32_t c = FLASHBVH_ROTATION_ONE / 5 * 4;
  const std::int32_t s = FLASHBVH_ROTATION_ONE / 5 * 3;
  const std::int32_t rotation[9] = {c, -s, 0, s, c, 0, 0, 0, FLASHBVH_ROTATION_ONE};
  const std::int32_t cells[3] = {3000, 1000, 500};
  flashbvh_pose pose;
  flashbvh_pose_rigid(rotation, cells, nullptr, &pose);
  return pose;
}

}  // namespace

TEST_CASE("the stack of every call in C stays within its budget") {
  const auto mesh = test::torus(20, 20, 6000, 2000);
  const auto image = image_of(
      bake::lay_out<std::uint16_t, Layout::post_indexed>(bake::build_median(mesh, 1), mesh));
  flashbvh_tree tree;
  flashbvh_pose poses[2] = {turned(), turned()};
  flashbvh_pose_translated(3000, 1000, 500, &poses[1]);
  flashbvh_status opened = FLASHBVH_STATUS_DONE;
  const std::uint32_t open = port::stack_of(
      [&] { opened = flashbvh_open(image.data(), image.size() * sizeof image[0], &tree); });
  REQUIRE(opened == FLASHBVH_STATUS_DONE);
  std::printf("budget: stack in C: %u bytes to open an image\n", static_cast<unsigned>(open));
  CHECK(open <= kMostOfOpen);
  for (const flashbvh_pose& pose : poses) {
    flashbvh_query query;
    flashbvh_pair found[4];
    flashbvh_status status = FLASHBVH_STATUS_DONE;
    std::uint32_t count = 0;
    std::uint32_t most = port::stack_of([&] { flashbvh_query_start(&query, &tree, &tree, &pose); });
    do {
      const std::uint32_t used =
          port::stack_of([&] { status = flashbvh_query_run(&query, 50, found, 4, &count); });
      most = used > most ? used : most;
    } while (status == FLASHBVH_STATUS_SUSPENDED || status == FLASHBVH_STATUS_FULL);
    CHECK(status == FLASHBVH_STATUS_DONE);
    const std::uint32_t question =
        port::stack_of([&] { status = flashbvh_count_pairs(&tree, &tree, &pose, &count); });
    CHECK(status == FLASHBVH_STATUS_DONE);
    CHECK(count != 0);
    std::printf("budget: stack in C: %u bytes for a run, %u for a question in one call\n",
                static_cast<unsigned>(most), static_cast<unsigned>(question));
    std::fflush(stdout);
    CHECK(most <= kMostOfRun);
    CHECK(question <= kMostOfQuestion);
  }
}
