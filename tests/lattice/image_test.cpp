// Images: written images open; what is no image, or one of another kind, is refused.
#include <cfloat>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "lattice/small_image.hpp"
#include "support/same_view.hpp"

using namespace flashbvh::detail;

TEST_CASE("an image opens in place as the tree that was baked") {
  for_rounds(100, [&](Random& random, int round) {
    const auto baked = baked_shape<kPost>(random, 1 + random.below(30));
    const bool levels = round % 2 == 0;
    Image image{image_of(baked, levels)};
    REQUIRE(bake::image_size(baked, levels) == image.size());
    REQUIRE(image.open<MeshWithLevels>() == (levels ? Status::done : Status::image_kind));
    const auto seen = view_unchecked<MeshWithLevels>(image.bytes());
    const Pose here = Pose::translated(0, 0, 0);
    REQUIRE(Query<StacklessPost>(seen, seen, here).status() ==
            (levels ? Status::suspended : Status::not_open));
    Mesh tree;
    REQUIRE(open_image(image.bytes(), image.size(), tree) == Status::done);
    REQUIRE(same_view<std::uint16_t, kPost>(tree, baked.view()));
    REQUIRE(Image{image_of(baked_shape<kPre>(random, 5))}.open<PreMeshWithLevels>() ==
            Status::done);
  });
}

TEST_CASE("a deviation is rounded up, in the unit and in cells") {
  struct Told {
    double deviation;
    double cell;
    std::uint16_t sixteenths;
  };
  constexpr double tenth = 0.1;  // as a float more than 0.1
  constexpr Told kTold[] = {
      {0, 1, 0},        {1e-300, 1, 1},     {0.5, 1, 8},          {0x1p-5, 0.5, 1},
      {0.500001, 1, 9}, {tenth, tenth, 17}, {4095.875, 1, 65534}, {4095.9, 1, 65535},
      {1e300, 1, 65535}};
  for (const Told& told : kTold) {
    CAPTURE(told.deviation, told.cell);
    auto baked = small_tree<kPost>();
    baked.deviation = told.deviation;
    baked.cell = told.cell;
    Image image{image_of(baked)};
    Mesh mesh;
    REQUIRE(open_image(image.bytes(), image.size(), mesh) == Status::done);
    CHECK(mesh.deviation_sixteenths == told.sixteenths);
    CHECK(view_unchecked<Mesh>(image.bytes()).deviation_sixteenths == told.sixteenths);
    ImageHeader header;
    std::memcpy(&header, image.bytes(), sizeof header);
    float deviation = 0;
    std::memcpy(&deviation, &header.deviation, sizeof deviation);
    CHECK(static_cast<double>(deviation) >= std::min(told.deviation, static_cast<double>(FLT_MAX)));
    CHECK(static_cast<double>(std::nextafter(deviation, 0.0F)) <= told.deviation);
  }
}

TEST_CASE("wide images open as wide trees") {
  Random random = test_random();
  const auto mesh = random_mesh(random, 20, 100, 30);
  const auto tree = any_tree(random, mesh);
  Image pre{image_of(bake::lay_out<std::uint32_t, kPre>(tree, mesh))};
  Image post{image_of(bake::lay_out<std::uint32_t, kPost>(tree, mesh), true)};
  CHECK(pre.open<PreMeshWithLevels32>() == Status::done);
  CHECK(post.open<MeshWithLevels32>() == Status::done);
  CHECK(post.open<Mesh32>() == Status::done);
  CHECK(post.open<Mesh>() == Status::image_kind);
  CHECK(pre.open<PreMeshWithLevels>() == Status::image_kind);
  CHECK(pre.open<MeshWithLevels32>() == Status::image_kind);
}

TEST_CASE("each way a file can be no image has its own status") {
  Image image{image_of(small_tree<kPost>(), true)};
  const auto status_of_flipped = [&](std::size_t offset) {
    image.bytes()[offset] ^= 1;
    const Status status = image.open<MeshWithLevels>();
    image.bytes()[offset] ^= 1;
    return status;
  };
  CHECK(status_of_flipped(offsetof(ImageHeader, magic)) == Status::image_not_flashbvh);
  CHECK(status_of_flipped(offsetof(ImageHeader, version)) == Status::image_version);
  CHECK(status_of_flipped(image.size() - 1) == Status::image_corrupt);
  CHECK(image.open<PreMeshWithLevels>() == Status::image_kind);
  MeshWithLevels tree;
  CHECK(open_image(image.bytes(), image.size() - 1, tree) == Status::image_truncated);
  CHECK(open_image(image.bytes() + 2, image.size(), tree) == Status::image_misaligned);
}

TEST_CASE("the checksum is CRC-32 as everyone computes it") {
  CHECK(crc32("123456789", 9) == 0xCBF43926u);
  CHECK(crc32("56789", 5, crc32("1234", 4)) == 0xCBF43926u);
}

TEST_CASE("a value of the header that means nothing is refused") {
  const auto status_with = [](std::size_t offset, int value) {
    Image image{image_of(small_tree<kPost>())};
    image.bytes()[offset] = static_cast<unsigned char>(value);
    image.repair_crc();
    return image.open<Mesh>();
  };
  for (const int value : {2, 8, 24, 64, 255}) {
    CAPTURE(value);
    CHECK(status_with(offsetof(ImageHeader, layout), value) == Status::image_invalid);
    CHECK(status_with(offsetof(ImageHeader, index_bits), value) == Status::image_invalid);
  }
  CHECK(status_with(offsetof(ImageHeader, flags), 8) == Status::image_invalid);
  CHECK(status_with(offsetof(ImageHeader, padding) + 1, 1) == Status::image_invalid);
  Image pre{image_of(small_tree<kPre>())};
  pre.bytes()[offsetof(ImageHeader, flags)] = 0;  // a pre-indexed tree has levels
  pre.repair_crc();
  CHECK(pre.open<PreMeshWithLevels>() == Status::image_invalid);
}

TEST_CASE("a header alone, of an image without nodes, is refused before a root is looked for") {
  ImageHeader header;
  std::memcpy(&header, image_of(small_tree<kPost>(), true).data(), sizeof header);
  header.shell_count = header.node_count = header.leaf_count = header.triangle_count =
      header.vertex_count = 0;
  header.byte_count = sizeof header;
  Image image{std::vector<std::uint32_t>(sizeof header / 4)};
  std::memcpy(image.bytes(), &header, sizeof header);
  image.repair_crc();
  CHECK(image.open<MeshWithLevels>() == Status::image_invalid);
  CHECK(image.open<Mesh>() == Status::image_invalid);
  CHECK(image.open<PreMeshWithLevels>() == Status::image_kind);
}

TEST_CASE("a byte other than zero in any gap is refused") {
  // 9 nodes, 7 triangles, 5 leaves, 21 vertices, 7 shells, a name of 3 bytes: a gap after each.
  auto baked = small_tree<kPost>();
  baked.name = "any";
  Image image{image_of(baked, true)};
  ImageHeader header;
  std::memcpy(&header, image.bytes(), sizeof header);
  const ImageOffsets at = image_offsets(header);
  const std::uint64_t gaps[] = {at.climb,          at.triangles, at.triangle_ids, at.leaf_offsets,
                                at.shell_vertices, at.name,      at.end};
  for (const std::uint64_t end : gaps) {
    for (const std::uint64_t offset : {end - (end == at.end ? 1 : 2), end - 1}) {
      CAPTURE(end, offset);
      REQUIRE(image.bytes()[offset] == 0);
      image.bytes()[offset] = 1;
      image.repair_crc();
      CHECK(image.open<MeshWithLevels>() == Status::image_invalid);
      image.bytes()[offset] = 0;
    }
  }
}

TEST_CASE("bits between the ranks of a wide node are refused") {
  Random random = test_random();
  const auto mesh = random_mesh(random, 4, 100, 30);
  auto baked = bake::lay_out<std::uint32_t, kPost>(bake::build_median(mesh, 1), mesh);
  REQUIRE(Image{image_of(baked)}.open<Mesh32>() == Status::done);
  for (const unsigned bit : {8u, 15u, 16u, 23u}) {
    baked.nodes[0].data ^= 1u << bit;
    CHECK(Image{image_of(baked)}.open<Mesh32>() == Status::image_invalid);
    baked.nodes[0].data ^= 1u << bit;
  }
}

TEST_CASE("a leaf of 255 triangles is good, one of 256 is not") {
  Random random = test_random();
  for (const std::uint32_t size : {255u, 256u}) {
    const auto mesh = random_mesh(random, size, 100, 30);
    const auto tree = bake::build_median(mesh, size);
    REQUIRE(tree.nodes.size() == 1);
    const Status wanted = size == 255 ? Status::done : Status::image_invalid;
    CHECK(Image{image_of(baked(tree, mesh))}.open<Mesh>() == wanted);
    CHECK(Image{image_of(bake::lay_out<std::uint32_t, kPre>(tree, mesh))}
              .open<PreMeshWithLevels32>() == wanted);
  }
}
