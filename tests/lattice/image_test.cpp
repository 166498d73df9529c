// Images: written images open; an image that breaks a rule of the format is refused.
#include <cfloat>
#include <functional>

#include "bake/image_bytes.hpp"
#include "bake/made_levels.hpp"
#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "heap_guard.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

constexpr Layout kPre = Layout::pre_indexed;
constexpr Layout kPost = Layout::post_indexed;

template <Layout layout>
Baked<layout> baked_shape(Random& random, std::uint32_t triangles) {
  const auto mesh = random_mesh(random, triangles, 100, 30);
  return baked<layout>(any_tree(random, mesh), mesh);
}

/// An image with changeable bytes.
struct Image {
  std::vector<std::uint32_t> words;

  unsigned char* bytes() { return reinterpret_cast<unsigned char*>(words.data()); }
  std::size_t size() const { return words.size() * sizeof words[0]; }
  void repair_crc() {
    const std::uint32_t crc = image_crc(bytes(), size());
    std::memcpy(bytes() + offsetof(ImageHeader, crc), &crc, sizeof crc);
  }
  template <class TreeType>
  Status open() {
    TreeType tree;
    const HeapForbidden guard;
    return open_image(bytes(), size(), tree);
  }
};

/// The status of a valid tree after one change.
template <Layout layout, class Change>
Status status_after(Baked<layout> baked, Change change) {
  change(baked);
  return Image{image_of(baked, true)}.template open<BasicMeshWithLevels<std::uint16_t, layout>>();
}

/// The status of an image without levels, after one change.
template <class Change>
Status status_without_levels(Baked<kPost> baked, Change change) {
  change(baked);
  return Image{image_of(baked)}.open<Mesh>();
}

/// Three levels, one node with three children, leaves of one and two triangles.
template <Layout layout>
Baked<layout> small_tree() {
  Random random(7);
  const auto mesh = random_mesh(random, 7, 1000, 300);
  bake::BuildTree tree;
  const auto leaf = [&](std::initializer_list<std::uint32_t> triangles) {
    tree.nodes.push_back({box_of_all(mesh, triangles), {}, triangles});
  };
  tree.nodes.push_back({box_of_all(mesh, {0, 1, 2, 3, 4, 5, 6}), {1, 2, 3}, {}});
  tree.nodes.push_back({box_of_all(mesh, {0, 1, 2}), {4, 5}, {}});
  leaf({3});
  tree.nodes.push_back({box_of_all(mesh, {4, 5, 6}), {6}, {}});
  leaf({0, 1});
  leaf({2});
  tree.nodes.push_back({box_of_all(mesh, {4, 5, 6}), {7, 8}, {}});
  leaf({4, 5});
  leaf({6});
  return baked<layout>(tree, mesh);
}

/// An image whose `count` is too large by 65,536, with memory for the additional elements.
Image with_more(std::uint32_t ImageHeader::*count) {
  const auto baked = small_tree<kPost>();
  const Image small{image_of(baked, true)};
  ImageHeader header;
  std::memcpy(&header, small.words.data(), sizeof header);
  const ImageOffsets from = image_offsets(header);
  header.*count += 0x10000;
  const ImageOffsets to = image_offsets(header);
  header.byte_count = static_cast<std::uint32_t>(to.end);
  Image large{std::vector<std::uint32_t>(header.byte_count / 4)};
  std::memcpy(large.bytes(), &header, sizeof header);
  const auto* const bytes = reinterpret_cast<const unsigned char*>(small.words.data());
  const std::uint64_t parts[][3] = {{from.nodes, from.levels, to.nodes},
                                    {from.levels, from.climb, to.levels},
                                    {from.climb, from.triangles, to.climb},
                                    {from.triangles, from.triangle_ids, to.triangles},
                                    {from.triangle_ids, from.leaf_offsets, to.triangle_ids},
                                    {from.leaf_offsets, from.vertices, to.leaf_offsets},
                                    {from.vertices, from.shell_vertices, to.vertices},
                                    {from.shell_vertices, from.name, to.shell_vertices}};
  for (const auto& [begin, end, at] : parts) {
    std::memcpy(large.bytes() + at, bytes + begin, static_cast<std::size_t>(end - begin));
  }
  large.repair_crc();
  return large;
}

}  // namespace

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
    REQUIRE(tree.node_count == baked.nodes.size());
    REQUIRE(std::memcmp(tree.nodes, baked.nodes.data(),
                        sizeof(Node<std::uint16_t>) * baked.nodes.size()) == 0);
    REQUIRE(std::memcmp(tree.vertices, baked.vertices.data(),
                        sizeof(Vertex) * baked.vertices.size()) == 0);
    REQUIRE(tree.stack_need == baked.stack_need);
    REQUIRE(tree.cell_bits == baked.view().cell_bits);
    REQUIRE((tree.leaf_offsets == nullptr) == baked.leaf_offsets.empty());
    REQUIRE(tree.shell_count == baked.shell_vertices.size());
    REQUIRE(
        std::equal(baked.shell_vertices.begin(), baked.shell_vertices.end(), tree.shell_vertices));
    REQUIRE(tree.longest_edge == baked.longest_edge);
    REQUIRE(tree.is_closed == baked.is_closed);
    REQUIRE(tree.deviation_sixteenths == baked.view().deviation_sixteenths);
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

/// Changes that each break one rule of the arrays.
template <Layout layout>
std::vector<std::function<void(Baked<layout>&)>> broken_arrays(std::size_t last) {
  const auto stray = [](const Vertex& v) {
    return [v](Baked<layout>& t) { t.vertices.push_back(v); };
  };
  return {
      [](auto& t) { t.nodes[0].link -= 1; },
      [](auto& t) { t.nodes[1].link = 0; },
      [](auto& t) { t.nodes[2].link = 1; },
      [last](auto& t) { t.nodes[last].link = static_cast<std::uint16_t>(last + 9); },
      [](auto& t) { t.nodes[0].box.upper_xy -= 1; },
      [](auto& t) { t.nodes[0].box.z |= 0x8000; },
      [](auto& t) { t.nodes[1].box.lower_xy = 0; },
      [](auto& t) { t.nodes[0].box.upper_xy = (t.nodes[0].box.upper_xy & 0xFFFF0000u) | 0x8000u; },
      [](auto& t) {
        t.nodes[0].box.lower_xy = (t.nodes[0].box.lower_xy & 0x0000FFFFu) | 0x80000000u;
      },
      [](auto& t) { t.nodes[0].box.z = (t.nodes[0].box.z & 0xFFFF0000u) | 0x8000u; },
      [](auto& t) { t.nodes[0].data = static_cast<std::uint16_t>(t.nodes[0].data & 0xFF00); },
      [](auto& t) { t.nodes[0].data = 127; },
      [](auto& t) { t.nodes[1].data = static_cast<std::uint16_t>(t.nodes[1].data ^ 1); },
      [](auto& t) {
        t.nodes[1].data = static_cast<std::uint16_t>(126 << 8 | (t.nodes[1].data & 255));
      },
      [last](auto& t) { t.nodes[last].data ^= 1; },
      [](auto& t) { t.triangles[0].corner[2] = 0xFFFF; },
      [](auto& t) { std::swap(t.triangles.front(), t.triangles.back()); },
      [](auto& t) { t.leaf_offsets[0] = 1; },
      [](auto& t) { t.leaf_offsets[1] = 0; },
      [](auto& t) { t.leaf_offsets.back() += 1; },
      [](auto& t) { t.leaf_offsets.back() -= 1; },
      [](auto& t) {
        t.leaf_count += 1;
        t.leaf_offsets.push_back(t.leaf_offsets.back());
      },
      [](auto& t) { t.vertices[0].x = 16384; },
      [](auto& t) { t.shell_vertices.clear(); },
      [](auto& t) { t.shell_vertices[0] = static_cast<std::uint16_t>(t.vertices.size()); },
      [](auto& t) { t.shell_vertices.push_back(t.shell_vertices.back()); },
      [](auto& t) { t.shell_vertices[1] = 0; },
      // Vertices of no triangle, which no box covers.
      stray({16384, 0, 0}),
      stray({0, -16384, 0}),
      stray({0, 0, INT16_MIN}),
  };
}

/// Changes that each break one rule of the levels.
template <Layout layout>
std::vector<std::function<void(Baked<layout>&)>> broken_levels(std::size_t last) {
  return {
      [](auto& t) { t.levels[0] = 1; },        [last](auto& t) { t.levels[last] += 1; },
      [last](auto& t) { t.levels[last] = 0; }, [](auto& t) { t.climb[0] = 1; },
      [last](auto& t) { t.climb[last] += 1; }, [](auto& t) { t.climb[1] += 1; },
  };
}

/// Changes that each break one rule of the header.
template <Layout layout>
std::vector<std::function<void(Baked<layout>&)>> broken_headers() {
  return {
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

TEMPLATE_TEST_CASE("an image with a good checksum that breaks a rule is refused", "",
                   PreMeshWithLevels, MeshWithLevels) {
  constexpr Layout layout = TestType::kLayout;
  const Baked<layout> good = small_tree<layout>();
  REQUIRE(status_after(good, [](auto&) {}) == Status::done);
  const std::size_t last = good.nodes.size() - 1;
  for (const auto& changes : {broken_arrays<layout>(last), broken_headers<layout>()}) {
    for (std::size_t i = 0; i < changes.size(); ++i) {
      CAPTURE(i);
      CHECK(status_after(good, changes[i]) == Status::image_invalid);
      if constexpr (layout == kPost) {
        CHECK(status_without_levels(good, changes[i]) == Status::image_invalid);
      }
    }
  }
  for (const auto& change : broken_levels<layout>(last)) {
    CHECK(status_after(good, change) == Status::image_invalid);
    if constexpr (layout == kPost) {
      CHECK(status_without_levels(good, change) == Status::done);
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
    CHECK(status_after(small_tree<kPost>(), change) == Status::done);
  }
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

TEST_CASE("a layout or an index width that is none is refused as such") {
  Image image{image_of(small_tree<kPost>())};
  for (const std::size_t offset :
       {offsetof(ImageHeader, layout), offsetof(ImageHeader, index_bits)}) {
    const unsigned char right = image.bytes()[offset];
    for (const int value : {2, 8, 24, 64, 255}) {
      image.bytes()[offset] = static_cast<unsigned char>(value);
      image.repair_crc();
      CHECK(image.open<MeshWithLevels>() == Status::image_invalid);
    }
    image.bytes()[offset] = right;
  }
}

TEST_CASE("a byte other than zero in the header's padding is refused") {
  Image image{image_of(small_tree<kPost>())};
  image.bytes()[offsetof(ImageHeader, padding) + 1] = 1;
  image.repair_crc();
  CHECK(image.open<Mesh>() == Status::image_invalid);
}

TEST_CASE("a flag that is none is refused, and a pre-indexed image without levels") {
  Image post{image_of(small_tree<kPost>())};
  Image pre{image_of(small_tree<kPre>())};
  REQUIRE(post.open<Mesh>() == Status::done);
  post.bytes()[offsetof(ImageHeader, flags)] |= 4;
  post.repair_crc();
  CHECK(post.open<Mesh>() == Status::image_invalid);
  pre.bytes()[offsetof(ImageHeader, flags)] &= static_cast<unsigned char>(~kImageHasLevels);
  pre.repair_crc();
  CHECK(pre.open<PreMeshWithLevels>() == Status::image_invalid);
}

TEST_CASE("a last node with neither children nor triangles is refused") {
  for (unsigned parent_rank = 1; parent_rank <= 126; ++parent_rank) {
    CHECK(status_after(small_tree<kPost>(), [&](auto& t) {
            t.nodes.back().data = static_cast<std::uint16_t>(1u << 8 | parent_rank);
            t.leaf_count -= 1;
            t.leaf_offsets.pop_back();
            t.triangles.resize(t.leaf_offsets.back());
            t.triangle_ids.resize(t.leaf_offsets.back());
          }) == Status::image_invalid);
  }
}

TEST_CASE("counts beyond the index type are refused, though what they are cut to would be sound") {
  for (std::uint32_t ImageHeader::*const count :
       {&ImageHeader::node_count, &ImageHeader::leaf_count, &ImageHeader::triangle_count,
        &ImageHeader::vertex_count, &ImageHeader::shell_count}) {
    CHECK(with_more(count).open<MeshWithLevels>() == Status::image_invalid);
  }
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
