// Instructions to open an image, counted on the target.
#include <catch2/catch.hpp>

#include "flashbvh/image.hpp"
#include "insn.hpp"
#include "support/print.hpp"
#include "thick.fbvh.h"
#include "thin.fbvh.h"

using namespace flashbvh;

namespace {

/// Without the checksum's, per node of a default tree with its triangles and vertices.
constexpr uint32_t kMostPerNode = 480;

void check_opening(const char* name, const uint32_t* words, size_t size) {
  Mesh mesh;
  Status status{};
  const uint32_t all = port::instructions_of([&] { status = open_image(words, size, mesh); });
  REQUIRE(status == Status::done);
  uint32_t crc = 0;
  const uint32_t of_checksum = port::instructions_of([&] { crc = image_crc(words, size); });
  REQUIRE(crc == words[3]);
  const uint32_t per_node = (all - of_checksum) / mesh.node_count;
  test::print("budget: opening ", name, ": ", per_node, " instructions a node, at most ",
              kMostPerNode, "\n");
  CHECK(per_node <= kMostPerNode);
}

}  // namespace

TEST_CASE("opening an image keeps within its budget") {
  check_opening("thick", thick_image, sizeof thick_image);
  check_opening("thin", thin_image, sizeof thin_image);
}
