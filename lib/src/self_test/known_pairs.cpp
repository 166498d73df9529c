// Known-answer test of pairs.
#include "flashbvh/collide.hpp"
#include "flashbvh/self_test.hpp"
#include "known_answers.hpp"

namespace flashbvh {
namespace detail {

/// Runs in at most as many slices as a correct walk needs, so that a broken walk ends.
uint32_t known_pairs_digest() {
  constexpr uint32_t slice = 400;
  const Mesh mesh = known_mesh();
  AnswerDigest digest;
  for_each_known_pose(1, [&](const Pose& pose) {
    PairQuery query(mesh, mesh, pose);
    RunResult run = {Status::suspended, 0, 0};
    for (int slices = 0; slices < 32 && run.status == Status::suspended; ++slices) {
      run = query.run(slice, [&](const PairQuery::Pair& pair) {
        digest.add(pair.a, pair.b);
        return true;
      });
      digest.add(run.work);
    }
    digest.add(static_cast<uint32_t>(run.status));
  });
  return digest.value();
}

}  // namespace detail

Status test_known_pairs() {
  return detail::passed(detail::known_pairs_digest(), 0x7057BD99u);
}

}  // namespace flashbvh
