// An image with a good checksum that breaks a rule of the format is refused.
#include <functional>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "lattice/small_image.hpp"

using namespace flashbvh::detail;

namespace {

/// The status of a valid tree's image after one change.
template <class MeshType, class Change>
Status status_after(Baked<MeshType::kLayout> baked, Change change) {
  change(baked);
  const bool levels = !std::is_same_v<MeshType, Mesh>;
  return Image{image_of(baked, levels)}.template open<MeshType>();
}

/// Changes that each break one rule of the arrays or of the header; tree_check_test.cpp has links,
/// leaves and levels.
template <Layout layout>
std::vector<std::function<void(Baked<layout>&)>> rule_breaks() {
  return {
      [](auto& t) { t.nodes[0].box.upper_xy -= 1; },
      [](auto& t) { t.nodes[0].box.z |= 0x8000; },
      [](auto& t) { t.nodes[1].box.lower_xy = 0; },
      [](auto& t) { t.nodes[0].box.upper_xy = (t.nodes[0].box.upper_xy & 0xFFFF0000u) | 0x8000u; },
      [](auto& t) {
        t.nodes[0].box.lower_xy = (t.nodes[0].box.lower_xy & 0x0000FFFFu) | 0x80000000u;
      },
      [](auto& t) { t.nodes[0].box.z = (t.nodes[0].box.z & 0xFFFF0000u) | 0x8000u; },
      [](auto& t) { t.nodes[1].data = static_cast<std::uint16_t>(t.nodes[1].data ^ 1); },
      [](auto& t) {
        t.nodes[1].data = static_cast<std::uint16_t>(126 << 8 | (t.nodes[1].data & 255));
      },
      [](auto& t) { t.triangles[0].corner[2] = 0xFFFF; },
      [](auto& t) { std::swap(t.triangles.front(), t.triangles.back()); },
      [](auto& t) { t.vertices[0].x = 16384; },
      [](auto& t) { t.shell_vertices.clear(); },
      [](auto& t) { t.shell_vertices[0] = static_cast<std::uint16_t>(t.vertices.size()); },
      [](auto& t) { t.shell_vertices.push_back(t.shell_vertices.back()); },
      [](auto& t) { t.shell_vertices[1] = 0; },
      // Vertices of no triangle, which no box covers.
      [](auto& t) {
        t.vertices.push_back({16384, 0, 0});
      },
      [](auto& t) {
        t.vertices.push_back({0, -16384, 0});
      },
      [](auto& t) {
        t.vertices.push_back({0, 0, INT16_MIN});
      },
      // Counts beyond the index type, though what they are cut to would be sound.
      [](auto& t) { t.nodes.resize(t.nodes.size() + 0x10000); },
      [](auto& t) { t.vertices.resize(t.vertices.size() + 0x10000); },
      [](auto& t) { t.shell_vertices.resize(t.shell_vertices.size() + 0x10000); },
      [](auto& t) {
        t.triangles.resize(t.triangles.size() + 0x10000);
        t.triangle_ids.resize(t.triangles.size());
      },
      [](auto& t) {
        t.leaf_count += 0x10000;
        t.leaf_offsets.resize(t.leaf_offsets.size() + 0x10000);
      },
      // The header.
      [](auto& t) { t.stack_need -= 1; },
      [](auto& t) { t.stack_need += 1; },
      [](auto& t) { t.depth += 1; },
      [](auto& t) { t.depth -= 1; },
      [](auto& t) { t.leaf_size += 1; },
      [](auto& t) { t.leaf_size -= 1; },
      [](auto& t) { t.arity += 1; },
      [](auto& t) { t.arity -= 1; },
      [](auto& t) { t.origin[0] = kMaxOrigin + 1; },
      [](auto& t) { t.origin[1] = -kMaxOrigin - 1; },
      [](auto& t) { t.origin[2] = INT32_MIN; },
      [](auto& t) { t.cell = 0; },
      [](auto& t) { t.cell = -1; },
      [](auto& t) { t.cell = -0.0; },
      [](auto& t) { t.cell = std::numeric_limits<double>::denorm_min(); },
      [](auto& t) { t.cell = std::numeric_limits<double>::infinity(); },
      [](auto& t) { t.cell = std::numeric_limits<double>::quiet_NaN(); },
      [](auto& t) { t.longest_edge += 1; },
      [](auto& t) { t.longest_edge -= 1; },
      [](auto& t) { t.is_closed = !t.is_closed; },
      [](auto& t) { t.unit = static_cast<Unit>(kUnitCount); },
      [](auto& t) { t.name = std::string("a\0b", 3); },
      [](auto& t) { t.deviation = -0.0; },
      [](auto& t) { t.deviation = std::numeric_limits<double>::infinity(); },
      [](auto& t) { t.deviation = std::numeric_limits<double>::quiet_NaN(); },
  };
}

}  // namespace

TEMPLATE_TEST_CASE("an image with a good checksum that breaks a rule is refused", "",
                   PreMeshWithLevels, MeshWithLevels) {
  constexpr Layout layout = TestType::kLayout;
  const Baked<layout> good = small_tree<layout>();
  REQUIRE(status_after<TestType>(good, [](auto&) {}) == Status::done);
  const auto changes = rule_breaks<layout>();
  for (std::size_t i = 0; i < changes.size(); ++i) {
    CAPTURE(i);
    CHECK(status_after<TestType>(good, changes[i]) == Status::image_invalid);
    if constexpr (layout == kPost) {
      CHECK(status_after<Mesh>(good, changes[i]) == Status::image_invalid);
    }
  }
}

TEST_CASE("the largest origins and the smallest and largest cells are good") {
  const std::vector<std::function<void(Baked<kPost>&)>> changes = {
      [](auto& t) {
        t.origin = {kMaxOrigin, -kMaxOrigin, kMaxOrigin};
      },
      [](auto& t) { t.cell = std::numeric_limits<double>::min(); },
      [](auto& t) { t.cell = std::numeric_limits<double>::max(); },
      [](auto& t) { t.deviation = std::numeric_limits<double>::max(); },
      [](auto& t) { t.unit = Unit::foot; },
      [](auto& t) { t.name.assign(bake::kMaxNameSize, '\xFF'); },
  };
  for (const auto& change : changes) {
    CHECK(status_after<MeshWithLevels>(small_tree<kPost>(), change) == Status::done);
  }
}

TEST_CASE("slabs that do not hold their leaf's triangles are refused") {
  const auto good = small_tree<kPost>();
  const auto status_with = [&](std::size_t leaf, const auto& change) {
    return status_after<Mesh>(good, [&](auto& tree) { change(tree.slabs[leaf]); });
  };
  for (std::size_t leaf = 0; leaf < good.slabs.size(); ++leaf) {
    for (const int i : {0, 1}) {
      CAPTURE(leaf, i);
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s.of[i].thickness = 0; }) ==
            Status::image_invalid);
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s.least[i] += 1; }) == Status::image_invalid);
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s.least[i] -= 1, s.of[i].thickness += 2; }) ==
            Status::done);
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s.of[i].y = INT8_MIN; }) ==
            Status::image_invalid);
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s = {}, s.of[i].thickness = 6 << 5 | 8; }) ==
            Status::done);  // zeros hold everything; this range ends at 2^15
      CHECK(status_with(leaf, [i](LeafSlabs& s) { s = {}, s.of[i].thickness = 6 << 5 | 9; }) ==
            Status::image_invalid);
    }
  }
}
