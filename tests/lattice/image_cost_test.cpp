// Opening an image on the target: its stack, and its instructions, which must grow linearly with
// its size, whatever the tree's form.
#include <catch2/catch.hpp>

#include <cstdio>

#include "bake/image_bytes.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "insn.hpp"
#include "stack.hpp"
#include "support/shapes.hpp"
#include "support/torus.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// Bytes, from the call of open_image() down.
constexpr std::uint32_t kMostStack = 400;
/// The growth of the check's instructions, without the checksum, when the image doubles.
constexpr double kMostGrowth = 2.05;
/// Instructions per node with all its data: a leaf of one triangle, or an inner node.
constexpr double kMostPerNode = 400;

bake::BuildTree sah_of(const bake::LatticeMesh& mesh) {
  return bake::build_default(mesh, 1);
}
bake::BuildTree first_leaf_chain(const bake::LatticeMesh& mesh) {
  return chain(mesh, true);
}
bake::BuildTree last_leaf_chain(const bake::LatticeMesh& mesh) {
  return chain(mesh, false);
}
struct Cost {
  std::uint32_t nodes;
  std::uint32_t check;  ///< instructions without the checksum's
  std::uint32_t checksum;
  std::uint32_t bytes;
  std::uint32_t stack;
};

template <Layout layout>
Cost cost_of(const bake::BuildTree& tree, const bake::LatticeMesh& mesh) {
  const auto words = bake::image_of(baked<layout>(tree, mesh), true);
  const auto size = static_cast<std::uint32_t>(words.size() * sizeof words[0]);
  BasicMesh<std::uint16_t, layout> opened;
  Status status = Status::image_invalid;
  Cost cost{};
  cost.bytes = size;
  const std::uint32_t all =
      port::instructions_of([&] { status = open_image(words.data(), size, opened); });
  REQUIRE(status == Status::done);
  std::uint32_t crc = 0;
  cost.checksum = port::instructions_of([&] { crc = image_crc(words.data(), size); });
  REQUIRE(crc == words[3]);
  cost.check = all - cost.checksum;
  cost.nodes = opened.node_count;
  cost.stack = port::stack_of([&] { status = open_image(words.data(), size, opened); });
  REQUIRE(status == Status::done);
  return cost;
}

struct Shape {
  const char* name;
  bake::BuildTree (*build)(const bake::LatticeMesh&);
};

constexpr Shape kShapes[] = {{"default", sah_of},
                             {"chain, leaf first", first_leaf_chain},
                             {"chain, leaf last", last_leaf_chain},
                             {"star", star}};

template <Layout layout>
void check_shapes(const char* layout_name) {
  for (const Shape& shape : kShapes) {
    const bake::LatticeMesh small = torus(20, 10, 6000, 2000);
    const bake::LatticeMesh large = torus(40, 10, 6000, 2000);
    const Cost half = cost_of<layout>(shape.build(small), small);
    const Cost whole = cost_of<layout>(shape.build(large), large);
    const double growth = static_cast<double>(whole.check) / half.check;
    const double per_node = static_cast<double>(whole.check) / whole.nodes;
    std::printf(
        "budget: opening, %s %s: %u nodes, %.1f instructions a node, at most %.0f; "
        "%.2f a byte for the checksum; times %.3f for twice the triangles; stack %u "
        "bytes, at most %u\n",
        layout_name, shape.name, static_cast<unsigned>(whole.nodes), per_node, kMostPerNode,
        static_cast<double>(whole.checksum) / whole.bytes, growth,
        static_cast<unsigned>(whole.stack), static_cast<unsigned>(kMostStack));
    std::fflush(stdout);
    CHECK(growth <= kMostGrowth);
    CHECK(per_node <= kMostPerNode);
    CHECK(whole.stack == half.stack);
    CHECK(whole.stack <= kMostStack);
  }
}

}  // namespace

TEST_CASE("opening an image is linear in its size, whatever its shape, on constant memory") {
  check_shapes<Layout::pre_indexed>("pre");
  check_shapes<Layout::post_indexed>("post");
}
