// Images opened in place on every board: written images open, damaged images are refused.
#include <string.h>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "support/most_work.hpp"
#include "support/rounds.hpp"
#include "support/same_view.hpp"
#include "support/small_scene.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

const int kRounds = rounds(40, 1000);

/// An image of a small tree, by a separate writer.
class Image {
 public:
  template <class Tree>
  void write(const Tree& tree, bool levels = true) {
    TreeShape shape;
    REQUIRE(check_tree(tree, shape) == Status::done);
    ImageHeader header = {};
    header.magic = kImageMagic;
    header.version = kImageVersion;
    header.layout = static_cast<uint8_t>(Tree::kLayout);
    header.index_bits = 16;
    header.node_count = tree.node_count;
    header.leaf_count = tree.leaf_count;
    header.triangle_count = tree.triangle_count;
    header.vertex_count = tree.vertex_count;
    header.depth = shape.depth;
    header.stack_need = shape.stack_need;
    header.leaf_size = static_cast<uint8_t>(shape.leaf_size);
    header.name_size = sizeof kName;
    header.arity = static_cast<uint16_t>(shape.arity);
    memcpy(header.origin, tree.origin, sizeof header.origin);
    memcpy(header.cell, &tree.cell_bits, sizeof header.cell);
    header.shell_count = tree.shell_count;
    header.longest_edge = static_cast<uint16_t>(shape.longest_edge);
    header.unit = static_cast<uint8_t>(Unit::mm);
    header.flags = static_cast<uint8_t>((levels ? kImageHasLevels : 0) |
                                        (shape.is_closed ? kImageIsClosed : 0));
    const ImageOffsets at = image_offsets(header);
    size_ = header.byte_count = static_cast<uint32_t>(at.end);
    REQUIRE(size_ <= sizeof words_);
    memset(words_, 0, sizeof words_);
    memcpy(bytes(), &header, sizeof header);
    put(at.nodes, tree.nodes, tree.node_count);
    const uint32_t level_count = levels ? tree.node_count : 0u;
    put(at.levels, tree.levels, level_count);
    if constexpr (Tree::kLayout == Layout::post_indexed) {
      put(at.climb, tree.right_child_levels, level_count);
    } else {
      put(at.climb, tree.parents, level_count);
    }
    put(at.triangles, tree.triangles, tree.triangle_count);
    put(at.triangle_ids, tree.triangle_ids, tree.triangle_count);
    if (tree.leaf_count != tree.triangle_count) {
      put(at.leaf_offsets, tree.leaf_offsets, tree.leaf_count + 1u);
    }
    put(at.vertices, tree.vertices, tree.vertex_count);
    put(at.shell_vertices, tree.shell_vertices, tree.shell_count);
    put(at.name, kName, sizeof kName);
    repair_crc();
  }

  unsigned char* bytes() { return reinterpret_cast<unsigned char*>(words_); }
  uint32_t size() const { return size_; }
  void flip(uint32_t bit) { bytes()[bit / 8] ^= static_cast<unsigned char>(1u << (bit % 8)); }
  void repair_crc() {
    const uint32_t crc = image_crc(bytes(), size_);
    memcpy(bytes() + offsetof(ImageHeader, crc), &crc, sizeof crc);
  }
  template <class Tree>
  Status open() {
    Tree tree;
    return open_image(bytes(), size_, tree);
  }

 private:
  template <class Element>
  void put(uint64_t offset, const Element* elements, uint32_t count) {
    memcpy(bytes() + offset, elements, sizeof(Element) * count);
  }

  static constexpr char kName[3] = {'r', 'i', 'm'};
  static constexpr uint32_t kMostBytes =
      sizeof(ImageHeader) + digest::kMostNodes * (sizeof(Node<uint16_t>) + 2 * sizeof(uint16_t)) +
      digest::kMostTriangles * (sizeof(Corners<uint16_t>) + 2 * sizeof(uint16_t)) +
      digest::kMostVertices * sizeof(Vertex) + 10 * sizeof(uint32_t);
  uint32_t words_[kMostBytes / sizeof(uint32_t)];
  uint32_t size_ = 0;
};

template <class Tree>
struct Baked {
  digest::SmallMesh mesh;
  digest::SmallTree<Tree::kLayout> tree;

  /// Trees of at most `most` triangles.
  explicit Baked(Random& random, uint16_t most) {
    digest::make_mesh(random, digest::kScales[1], mesh);
    mesh.triangle_count = mesh.triangle_count < most ? mesh.triangle_count : most;
    const auto shape = static_cast<digest::Shape>(random.below(4));
    tree.make(mesh, shape, 1 + random.below(3));
  }
};

/// Whether two trees contain equal numbers.
template <class Tree>
bool same(const Tree& a, const Tree& b) {
  return a.node_count == b.node_count && a.leaf_count == b.leaf_count &&
         a.triangle_count == b.triangle_count && a.vertex_count == b.vertex_count &&
         a.stack_need == b.stack_need && a.cell_bits == b.cell_bits &&
         memcmp(a.origin, b.origin, sizeof a.origin) == 0 &&
         memcmp(a.nodes, b.nodes, sizeof *a.nodes * a.node_count) == 0 &&
         memcmp(a.levels, b.levels, sizeof *a.levels * a.node_count) == 0 &&
         memcmp(a.triangles, b.triangles, sizeof *a.triangles * a.triangle_count) == 0 &&
         memcmp(a.vertices, b.vertices, sizeof *a.vertices * a.vertex_count) == 0;
}

}  // namespace

TEMPLATE_TEST_CASE("small trees: an image opens in place as the tree that was written", "",
                   PreMeshWithLevels, MeshWithLevels) {
  for_rounds(kRounds, [&](Random& random, int) {
    const Baked<TestType> baked(random, digest::kMostTriangles);
    Image image;
    image.write(baked.tree.view());
    TestType tree;
    REQUIRE(open_image(image.bytes(), image.size(), tree) == Status::done);
    using Seen = BasicMesh<uint16_t, TestType::kLayout>;
    const bool equal =
        same(tree, baked.tree.view()) &&
        same_view<uint16_t, TestType::kLayout>(tree, view_unchecked<Seen>(image.bytes()));
    REQUIRE(equal);
  });
}

TEST_CASE("small trees: each way an image can be no image has its own status") {
  Random random = test_random(1);
  const Baked<MeshWithLevels> baked(random, 6);
  Image image;
  image.write(baked.tree.view());
  MeshWithLevels tree;
  for (uint32_t size = 0; size < image.size(); ++size) {
    REQUIRE(open_image(image.bytes(), size, tree) == Status::image_truncated);
  }
  CHECK(image.open<PreMeshWithLevels>() == Status::image_kind);
  image.flip(0);  // in the magic
  CHECK(image.open<MeshWithLevels>() == Status::image_not_flashbvh);
  image.flip(0);
  image.flip(8 * offsetof(ImageHeader, version));
  CHECK(image.open<MeshWithLevels>() == Status::image_version);
  image.flip(8 * offsetof(ImageHeader, version));
  memmove(image.bytes() + 2, image.bytes(), image.size());
  CHECK(open_image(image.bytes() + 2, image.size(), tree) == Status::image_misaligned);
}

TEMPLATE_TEST_CASE("small trees: every flipped bit of an image is refused", "", PreMeshWithLevels,
                   MeshWithLevels) {
  Random random = test_random(2);
  const Baked<TestType> baked(random, 6);
  Image image;
  image.write(baked.tree.view());
  for (uint32_t bit = 0; bit < 8 * image.size(); ++bit) {
    CAPTURE(bit);
    image.flip(bit);
    REQUIRE(image.open<TestType>() != Status::done);
    image.flip(bit);
  }
  CHECK(image.open<TestType>() == Status::done);
}

TEST_CASE("small trees: a query ends on whatever opens after a flipped bit, checksum repaired") {
  Random random = test_random(3);
  const Baked<MeshWithLevels> baked(random, 6);
  Image image;
  image.write(baked.tree.view());
  uint32_t opened = 0;
  const Pose pose = Pose::translated(0, 0, 0);
  for (uint32_t bit = 0; bit < 8 * image.size(); ++bit) {
    CAPTURE(bit);
    image.flip(bit);
    image.repair_crc();
    MeshWithLevels tree;
    if (open_image(image.bytes(), image.size(), tree) == Status::done) {
      ++opened;
      const uint32_t most = most_work_of_nodes(tree, tree);
      PairQuery query(tree, tree, pose);
      REQUIRE(query.run(most, [](const Pair&) { return true; }).status == Status::done);
    }
    image.flip(bit);
  }
  CHECK(opened > 0);  // a changed origin, or coordinate inside its box, can be valid
}

TEST_CASE("small trees: the checksum is CRC-32 as everyone computes it") {
  CHECK(crc32("123456789", 9) == 0xCBF43926u);
  CHECK(crc32("56789", 5, crc32("1234", 4)) == 0xCBF43926u);
}
