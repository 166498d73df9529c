
#include "bake/image_bytes.hpp"
#include "golden/golden.hpp"
#include "support/torus.hpp"

namespace flashbvh::test {
namespace {

enum class Builder { median, sah };

struct Recipe {
  Builder builder;
  std::uint32_t leaf_size;
  std::uint32_t arity;
  bool levels = false;
};

template <class Index, Layout layout>
BakedImage baked_image(const char* mesh_name, bake::LatticeMesh mesh, const Recipe& recipe) {
  mesh.cell = 0.125;
  const bool median = recipe.builder == Builder::median;
  bake::BuildTree tree =
      median ? bake::build_median(mesh, recipe.leaf_size) : bake::build_sah(mesh, recipe.leaf_size);
  if (recipe.arity > 2) {
    tree = bake::collapse(tree, recipe.arity);
  }
  const std::string name = std::string(mesh_name) +
                           (layout == Layout::pre_indexed ? "-pre-" : "-post-") +
                           std::to_string(8 * sizeof(Index)) + (median ? "-median-" : "-sah-") +
                           std::to_string(recipe.leaf_size) + "-" + std::to_string(recipe.arity) +
                           (recipe.levels ? "-levels" : "");
  auto baked = bake::lay_out<Index, layout>(tree, mesh);
  if (mesh_name == std::string("ring")) {
    baked.unit = Unit::mm;
    baked.name = mesh_name;
  }
  return {name, bake::image_of(baked, recipe.levels)};
}

/// A ring off its frame's origin, so that a rotation has to include the origin.
bake::LatticeMesh ring() {
  bake::LatticeMesh mesh = torus(6, 4, 700, 300);
  mesh.origin = {40, -25, 7};
  mesh.deviation = 0.0625;
  return mesh;
}

bake::LatticeMesh lone() {
  bake::LatticeMesh mesh;
  mesh.vertices = {{-600, -500, -90}, {800, -300, 100}, {-100, 900, 5}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

}  // namespace

std::vector<BakedImage> bake_golden_images() {
  using Narrow = std::uint16_t;
  using Wide = std::uint32_t;
  constexpr Layout pre = Layout::pre_indexed;
  constexpr Layout post = Layout::post_indexed;
  const bake::LatticeMesh knot = torus(4, 3, 500, 260);
  return {
      baked_image<Narrow, post>("ring", ring(), {Builder::sah, 1, 4}),  // bake's defaults
      baked_image<Narrow, post>("knot", knot, {Builder::median, 4, 2, true}),
      baked_image<Narrow, post>("lone", lone(), {Builder::sah, 1, 4}),
      baked_image<Narrow, pre>("ring", ring(), {Builder::median, 1, 2}),
      baked_image<Narrow, pre>("knot", knot, {Builder::sah, 4, 8}),
      baked_image<Wide, post>("knot", knot, {Builder::sah, 1, 8}),
      baked_image<Wide, pre>("knot", knot, {Builder::median, 4, 4}),
  };
}

}  // namespace flashbvh::test
