// Instructions of a query and of its parts, counted on the target.
#pragma once

#include <stdint.h>

#include "flashbvh/collide.hpp"
#include "report.hpp"

namespace figures {

/// Leaf planes that reject everything: a walk then visits only pairs of inner nodes, and the first
/// pair with a leaf.
struct NothingBelow {
  using Tree = flashbvh::Mesh;
  static constexpr bool kShapes = true;
  static constexpr bool kKnowsRoot = false;
  static constexpr bool kComparesLeaves = false;
  const flashbvh::Mesh& a;
  const flashbvh::Mesh& b;

  NothingBelow(const flashbvh::Mesh& mesh_a, const flashbvh::Mesh& mesh_b,
               const flashbvh::detail::Transform&)
      : a(mesh_a), b(mesh_b) {}
  template <class BoxTest>
  static void set_box_test(const BoxTest&) {}
  static bool is_taken(flashbvh::detail::Side, uint32_t) { return false; }
  static void take_again(flashbvh::detail::Side, uint32_t) {}
  static uint32_t work_of(flashbvh::detail::Side, uint32_t) { return 0; }
  static bool begin(flashbvh::detail::Side, uint32_t, const flashbvh::PackedBox*) { return false; }
  static bool may_touch(const flashbvh::PackedBox&) { return false; }
};

struct Walked {
  uint32_t visits;
  uint32_t leaf_pairs;
  uint32_t instructions;
};

/// The walk alone, from the first visit to the last, slabs included, without the preparation. Calls
/// `leaf_pair(i, j)` at each pair of leaves.
template <class Shapes, class BoxTest, class LeafPair>
Walked measure_walk(const BoxTest& bound, Shapes& shapes, const LeafPair& leaf_pair) {
  using Cursor = flashbvh::detail::PairCursor<uint16_t>;
  Walked walked{};
  const auto go_on = [&](uint32_t i, uint32_t j, const flashbvh::detail::Progress&) {
    ++walked.leaf_pairs;
    leaf_pair(i, j);
    return true;
  };
  Cursor cursor;
  flashbvh::detail::WalkRun<Cursor, decltype(go_on)> run(cursor, go_on, UINT32_MAX);
  walked.instructions = port::instructions_of([&] {
    (void)flashbvh::detail::walk<flashbvh::Ranked<flashbvh::Mesh>>(bound, shapes, run,
                                                                   flashbvh::detail::State::fresh);
  });
  walked.visits = UINT32_MAX - run.progress.visits_down();
  return walked;
}

/// The names of a set of figures: SET.MOTION.PROXIMITY.WHAT and SET.PART.MOTION.
struct FigureNames {
  const char* set;
  const char* motion;
  const char* proximity;  ///< null: none

  Name whole(const char* what) const { return {{set, motion, proximity, what}}; }
  Name part(const char* what) const { return {{set, what, motion}}; }
};

/// Adds a search for one pair (`first`) and, if there is one, a search with this pair as hint
/// (`held`). Returns whether there is one.
inline bool add_first(const FigureNames& names, const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                      const flashbvh::Pose& pose) {
  bool yes = false;
  measure(names.whole("first"), [&] { yes = flashbvh::intersects(a, b, pose).yes; });
  flashbvh::Witness<uint16_t> hint;
  if (flashbvh::intersects(a, b, pose, hint).yes) {
    measure(names.whole("held"), [&] { (void)flashbvh::intersects(a, b, pose, hint); });
  }
  return yes;
}

/// Adds a whole query (`query`), one to its first pair (add_first()), their counts, and their
/// parts: `visit`, outside the leaf phase; `leaf_visit`, in it, with slabs; `slab`: a slab, and
/// loading the leaf; `start`: preparing a query and its first visit; `leaf_pair`: the additional
/// cost of a pair of leaves. Returns whether the query and the walks agree.
bool add_query(const FigureNames& names, const flashbvh::Mesh& a, const flashbvh::Mesh& b,
               const flashbvh::Pose& pose, flashbvh::QueryStats& counts, uint32_t& work);

/// Adds SET.triangle_test: the exact test, without the transform, of each pair of triangles that
/// the query reaches.
void add_triangle_tests(const char* set, const flashbvh::Mesh& a, const flashbvh::Mesh& b,
                        const flashbvh::Pose& pose);

}  // namespace figures
