#include "evaluate/rows.hpp"

#include "evaluate/count_query.hpp"
#include "flashbvh/traversal/alternating_stack.hpp"
#include "flashbvh/traversal/leaf.hpp"
#include "flashbvh/traversal/ranked.hpp"
#include "flashbvh/traversal/ranked_stack.hpp"
#include "flashbvh/traversal/stackless.hpp"
#include "flashbvh/traversal/volume_stack.hpp"

namespace flashbvh::bench {
namespace {

/// The pose is read anew each time, so that no repetition can be optimised away.
struct VolatilePose {
  volatile std::int32_t x, y, z;
  Pose now() const { return Pose::translated(x, y, z); }
};

template <class Traversal>
Row make_row(const char* algorithm, const typename Traversal::Tree& a,
             const typename Traversal::Tree& b, const Point& translation) {
  return {algorithm, [a, b, translation](std::uint32_t repetitions) {
            const VolatilePose pose = {translation.x, translation.y, translation.z};
            scene::WalkStart<Traversal> start(a, b);
            Counts counts = {0, 0, 0, 0};
            std::uint32_t found = 0;
            for (std::uint32_t i = 0; i < repetitions; ++i) {
              counts = scene::count_query<Traversal>(a, b, pose.now(), start, found);
            }
            return counts;
          }};
}

template <class Index>
std::vector<Row> rows_of(const BothLayouts<Index>& a, const BothLayouts<Index>& b,
                         const Point& translation) {
  using LevelledPre = LevelledTree<Index, Layout::pre_indexed>;
  using LevelledPost = LevelledTree<Index, Layout::post_indexed>;
  using Post = Tree<Index, Layout::post_indexed>;
  const LevelledPre pre_a = a.pre.view();
  const LevelledPre pre_b = b.pre.view();
  const LevelledPost post_a = a.post.view();
  const LevelledPost post_b = b.post.view();
  using Pre = Tree<Index, Layout::pre_indexed>;
  return {
      make_row<VolumeStack<Pre>>("volume-stack", pre_a, pre_b, translation),
      make_row<AlternatingStack<LevelledPre>>("alternating-stack", pre_a, pre_b, translation),
      make_row<AlternatingStackless<LevelledPre>>("stackless", pre_a, pre_b, translation),
      make_row<AlternatingStackless<LevelledPost>>("stackless-post", post_a, post_b, translation),
      make_row<Leaf<Pre>>("leaf", pre_a, pre_b, translation),
      make_row<Ranked<Post>>("ranked", post_a, post_b, translation),
      make_row<RankedStack<Post>>("ranked-stack", post_a, post_b, translation),
  };
}

}  // namespace

std::vector<Row> make_rows(BakedObject& a, BakedObject& b, const Point& translation) {
  return a.fits_16_bits() && b.fits_16_bits()
             ? rows_of(a.baked<std::uint16_t>(), b.baked<std::uint16_t>(), translation)
             : rows_of(a.baked<std::uint32_t>(), b.baked<std::uint32_t>(), translation);
}

}  // namespace flashbvh::bench
