// Arbitrary bytes as a saved cursor: resume() refuses it, or the query ends, within as many visits
// as there are pairs of nodes.
#include <vector>

#include "bake/made_levels.hpp"
#include "flashbvh/image.hpp"
#include "fuzz/any_pose.hpp"
#include "golden/golden.hpp"
#include "support/any_query.hpp"
#include "support/most_work.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// A query with a stack has no position.
template <class Traversal, class Cursor>
void resume_and_end([[maybe_unused]] Query<Traversal>& query, const Cursor& position,
                    std::uint32_t most_visits, std::uint32_t most_work) {
  if constexpr (Traversal::kStackless) {
    const Status resumed = query.resume(position);
    if (resumed == Status::cursor_invalid) {
      require(query.stats().visits == 0, "a refused position changed the query");
    } else if (resumed == Status::suspended) {
      const auto sink = [](const typename Query<Traversal>::Pair&) { return true; };
      const Status status = query.run(most_work, sink).status;
      require(status == Status::done && query.stats().visits <= most_visits,
              "a resumed query does not end");
    }
  }
}

template <class Tree>
void fuzz(const KeptImage& image_a, const KeptImage& image_b, Input& input) {
  using Index = typename Tree::Index;
  Tree a;
  Tree b;
  std::vector<Index> levels_a;
  std::vector<Index> levels_b;
  if (open_levelled(image_a.bytes, image_a.size, a, levels_a) != Status::done ||
      open_levelled(image_b.bytes, image_b.size, b, levels_b) != Status::done) {
    return;
  }
  QueryCursor<Index> position{};
  position.state = static_cast<QueryState>(input.take<std::uint8_t>());
  position.a = input.take<Index>();
  position.b = input.take<Index>();
  position.untested = static_cast<std::uint16_t>(input.take<std::uint32_t>());
  const Pose pose = any_pose(input);
  for_each_query(a, b, pose, [&](const char*, auto& query) {
    resume_and_end(query, position, most_visits_of_nodes(a, b), most_work_of_nodes(a, b));
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Input input(bytes, size);
  const auto chosen = input.take<std::uint8_t>();
  const KeptImage& a = kKeptImages[(chosen & 15u) % kKeptImageCount];
  const KeptImage& b = kKeptImages[(chosen >> 4u) % kKeptImageCount];
  const Input rest = input;
  fuzz<PreMeshWithLevels>(a, b, input = rest);
  fuzz<MeshWithLevels>(a, b, input = rest);
  fuzz<PreMeshWithLevels32>(a, b, input = rest);
  fuzz<MeshWithLevels32>(a, b, input = rest);
  return 0;
}
