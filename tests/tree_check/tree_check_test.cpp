// The check of a tree's contents: of all arrays that differ from a tree's in up to four places,
// exactly those of a tree pass. Arrays lie in heap blocks of their size, so that the address
// sanitizer detects any other read.
#include <set>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

using namespace flashbvh::detail;

namespace {

constexpr std::uint16_t kLeaf = Node<std::uint16_t>::kLeafFlag;

/// The number of places changed at once; a board under QEMU is too slow for all.
constexpr int kDepth = sizeof(void*) > 4 ? 4 : 3;

/// The fields that define a tree's form: each node's link, level, parent or right child level, and
/// whether it is a leaf.
using Fields = std::vector<std::uint16_t>;
constexpr std::size_t kFieldsPerNode = 4;

template <Layout layout>
Fields fields_of(const Baked<layout>& baked) {
  Fields fields;
  for (std::size_t i = 0; i < baked.nodes.size(); ++i) {
    const auto is_leaf = static_cast<std::uint16_t>(baked.nodes[i].is_leaf());
    fields.insert(fields.end(), {baked.nodes[i].link, baked.levels[i], baked.climb[i], is_leaf});
  }
  return fields;
}

const bake::LatticeMesh& mesh_of_equal_triangles() {
  static const bake::LatticeMesh mesh = [] {
    bake::LatticeMesh equal;
    equal.vertices = {{0, 0, 0}, {9, 0, 0}, {0, 9, 9}};
    equal.triangles.assign(10, {0, 1, 2});
    return equal;
  }();
  return mesh;
}

/// All trees of `count` nodes: node i > 0 is so far the last child of parents[i], an ancestor of
/// node i - 1 or this node.
template <class Use>
void for_each_tree(std::size_t count, std::vector<std::uint32_t>& parents, Use use) {
  if (parents.size() == count) {
    use(parents);
    return;
  }
  for (auto node = static_cast<std::uint32_t>(parents.size() - 1);; node = parents[node]) {
    parents.push_back(node);
    for_each_tree(count, parents, use);
    parents.pop_back();
    if (node == 0) {
      return;
    }
  }
}

template <Layout layout>
std::vector<Baked<layout>> all_trees(std::size_t count) {
  std::vector<Baked<layout>> trees;
  std::vector<std::uint32_t> start = {0};
  for_each_tree(count, start, [&](const std::vector<std::uint32_t>& parents) {
    const Box box = bake::box_of(mesh_of_equal_triangles(), 0);
    bake::BuildTree tree;
    tree.nodes.assign(parents.size(), {box, {}, {}});
    for (std::uint32_t i = 1; i < parents.size(); ++i) {
      tree.nodes[parents[i]].children.push_back(i);
    }
    std::uint32_t triangle = 0;
    for (bake::BuildNode& node : tree.nodes) {
      if (node.is_leaf()) {
        node.triangles = {triangle++};
      }
    }
    trees.push_back(baked<layout>(tree, mesh_of_equal_triangles()));
  });
  return trees;
}

template <Layout layout>
bool passes(const Baked<layout>& baked, bool levels = true) {
  const auto arrays = levels ? ImageLevels<std::uint16_t>{baked.levels.data(), baked.climb.data()}
                             : ImageLevels<std::uint16_t>{};
  TreeShape shape;
  return check_tree(baked.view(), arrays, shape) == Status::done;
}

/// The tree with other fields; numbers leaves and their triangles in order; ranks are 1.
template <Layout layout>
bool passes(Baked<layout>& baked, const Fields& fields, bool levels) {
  baked.leaf_count = 0;
  for (std::size_t i = 0; i < baked.nodes.size(); ++i) {
    const std::uint16_t* const field = &fields[kFieldsPerNode * i];
    const auto ranks = static_cast<std::uint16_t>(1u << 8 | (i == 0 ? kRootParentRank : 1));
    baked.nodes[i].link = field[0];
    baked.levels[i] = field[1];
    baked.climb[i] = field[2];
    baked.nodes[i].data =
        field[3] != 0 ? static_cast<std::uint16_t>(kLeaf | baked.leaf_count++) : ranks;
  }
  if (baked.triangles.size() != baked.leaf_count) {
    baked.triangles.assign(baked.leaf_count, {{0, 1, 2}});
    baked.triangle_ids.assign(baked.leaf_count, 0);
  }
  return passes(baked, levels);
}

bool is_of_levels(std::size_t field) {
  return field % kFieldsPerNode == 1 || field % kFieldsPerNode == 2;
}

/// Sets up to `depth` of the fields from `first` on to every other possible value; by default
/// leaves levels unchanged.
template <class Use>
void for_each_change(Fields& fields, std::size_t first, int depth, bool levels, const Use& use) {
  use(fields);
  if (depth == 0) {
    return;
  }
  const auto nodes = static_cast<std::uint16_t>(fields.size() / kFieldsPerNode);
  for (std::size_t i = first; i < fields.size(); ++i) {
    if (!levels && is_of_levels(i)) {
      continue;
    }
    const std::uint16_t kept = fields[i];
    const std::uint16_t most = i % kFieldsPerNode == 3 ? 1 : static_cast<std::uint16_t>(nodes + 1);
    for (std::uint16_t value = 0; value <= most; ++value) {
      if (value != kept) {
        fields[i] = value;
        for_each_change(fields, i + 1, depth - 1, levels, use);
      }
    }
    fields[i] = kept;
  }
}

/// Without levels, trees with equal links and kinds are equal.
Fields without_levels(Fields fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    fields[i] = is_of_levels(i) ? std::uint16_t{0} : fields[i];
  }
  return fields;
}

template <Layout layout>
void check_all_changes(std::size_t count, int depth, bool levels = true) {
  std::vector<Baked<layout>> trees = all_trees<layout>(count);
  for (auto& tree : trees) {
    tree.slabs.clear();  // a changed tree may have more leaves
  }
  std::set<Fields> sound;
  for (const auto& tree : trees) {
    sound.insert(levels ? fields_of(tree) : without_levels(fields_of(tree)));
  }
  REQUIRE(sound.size() == trees.size());
  for (auto& tree : trees) {
    Fields fields = fields_of(tree);
    for_each_change(fields, 0, depth, levels, [&](const Fields& changed) {
      const bool is_sound =
          (levels ? sound.count(changed) : sound.count(without_levels(changed))) != 0;
      if (passes(tree, changed, levels) != is_sound) {
        CAPTURE(changed);
        FAIL("the check is wrong about these fields");
      }
    });
  }
}

/// A root with three leaves of two triangles each.
template <Layout layout>
Baked<layout> three_leaves() {
  const Box box = bake::box_of(mesh_of_equal_triangles(), 0);
  bake::BuildTree tree;
  tree.nodes = {{box, {1, 2, 3}, {}}, {box, {}, {0, 1}}, {box, {}, {2, 3}}, {box, {}, {4, 5}}};
  auto baked = test::baked<layout>(tree, mesh_of_equal_triangles());
  baked.slabs.clear();
  REQUIRE(passes(baked));
  return baked;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("of all links, levels, climbs and kinds, exactly those of a tree pass", "",
                       ((Layout layout), layout), Layout::pre_indexed, Layout::post_indexed) {
  check_all_changes<layout>(1, 3);
  check_all_changes<layout>(2, 3);
  check_all_changes<layout>(3, 3);
  check_all_changes<layout>(4, kDepth);
  check_all_changes<layout>(5, kDepth - 1);
  check_all_changes<layout>(6, 2);
}

TEST_CASE("of all links and kinds without levels, exactly those of a post-indexed tree pass") {
  for (std::size_t count = 1; count <= 6; ++count) {
    check_all_changes<Layout::post_indexed>(count, count <= 5 ? kDepth : kDepth - 1, false);
  }
}

TEMPLATE_TEST_CASE_SIG("leaves own all triangles, in order, each at least one", "",
                       ((Layout layout), layout), Layout::pre_indexed, Layout::post_indexed) {
  const auto good = three_leaves<layout>();
  std::uint32_t passed = 0;
  for (std::uint16_t i = 0; i <= 7; ++i) {
    for (std::uint16_t j = 0; j <= 7; ++j) {
      for (std::uint16_t k = 0; k <= 7; ++k) {
        for (std::uint16_t end = 0; end <= 7; ++end) {
          auto baked = good;
          baked.leaf_offsets = {i, j, k, end};
          baked.leaf_offsets.shrink_to_fit();
          const bool sound = i == 0 && i < j && j < k && k < end && end == 6;
          REQUIRE(passes(baked) == sound);
          passed += sound ? 1 : 0;
        }
      }
    }
  }
  CHECK(passed == 10);
}

TEMPLATE_TEST_CASE_SIG("more or fewer leaves than counted are refused", "",
                       ((Layout layout), layout), Layout::pre_indexed, Layout::post_indexed) {
  auto fewer = three_leaves<layout>();
  fewer.leaf_count = 2;
  fewer.leaf_offsets = std::vector<std::uint16_t>{0, 2, 6};
  CHECK_FALSE(passes(fewer));
  auto more = three_leaves<layout>();
  more.leaf_count = 4;
  more.leaf_offsets = std::vector<std::uint16_t>{0, 2, 4, 6, 6};
  CHECK_FALSE(passes(more));
}

TEMPLATE_TEST_CASE_SIG("every number of a leaf but its own, and every rank but 1 to 126 is refused",
                       "", ((Layout layout), layout), Layout::pre_indexed, Layout::post_indexed) {
  const auto good = three_leaves<layout>();
  for (std::uint32_t data = 0; data <= 0xFFFF; ++data) {
    auto baked = good;
    baked.nodes[0].data = static_cast<std::uint16_t>(data);
    const std::uint32_t rank = data >> 8;
    REQUIRE(passes(baked) == (rank >= 1 && rank <= 126 && (data & 0xFF) == 127));
    baked.nodes[0].data = good.nodes[0].data;
    baked.nodes[2].data = static_cast<std::uint16_t>(data);
    REQUIRE(passes(baked) == (data == (kLeaf | 1u)));
  }
}
