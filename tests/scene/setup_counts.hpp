// The counts of one traversal on one setup.
#ifndef FLASHBVH_TESTS_SCENE_SETUP_COUNTS_HPP
#define FLASHBVH_TESTS_SCENE_SETUP_COUNTS_HPP

#include <catch2/catch.hpp>

#include <cstdint>

#include "bake/baked_tree.hpp"
#include "evaluate/count_query.hpp"
#include "evaluate/setups.hpp"

namespace flashbvh::test {

/// The paper's tree, or the default one.
enum class Built : std::uint8_t { paper, by_default };

template <class Index, Layout layout>
bake::BakedTree<Index, layout> bake_object(const scene::PaperObject& object, Built built) {
  const bake::LatticeMesh mesh = make_mesh(object);
  return bake::lay_out<Index, layout>(
      built == Built::paper ? bake::build_median(mesh, 1) : bake::build_default(mesh, 1), mesh);
}

/// Traversal: with its trees' index type and layout. By boxes alone, as the paper's figures.
template <class Traversal>
Counts counts_of(const scene::Setup& setup, Built built = Built::paper) {
  using Index = typename Traversal::Tree::Index;
  constexpr Layout layout = Traversal::Tree::kLayout;
  const auto a = bake_object<Index, layout>(setup.a, built);
  const auto b = bake_object<Index, layout>(setup.b, built);
  const auto view_a = a.view();
  const auto view_b = b.view();
  scene::WalkStart<Traversal> start(view_a, view_b);
  const Point& t = setup.translation;
  std::uint32_t found = 0;
  const Counts counts = scene::count_query<Traversal, detail::BoxIntersection>(
      view_a, view_b, Pose::translated(t.x, t.y, t.z), start, found);
  CHECK(found == counts.triangle_pairs);
  return counts;
}

}  // namespace flashbvh::test

#endif
