// Images for tests, with changeable bytes.
#pragma once

#include "bake/image_bytes.hpp"
#include "bake/made_levels.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/query.hpp"
#include "heap_guard.hpp"
#include "support/shapes.hpp"
#include "support/test.hpp"

namespace flashbvh::test {

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

}  // namespace flashbvh::test
