// Collisions of meshes other than robots. Exits with 1 if a query's counts differ from the host's.
#include "flashbvh/collide.hpp"

#include "others.hpp"

using namespace flashbvh;

namespace figures {
namespace {

bool measure_pose(const MeshPair& pair, const QueryPose& query_pose, const char* motion,
                  const char* proximity) {
  const FigureNames names = {pair.a_name, motion, proximity};
  const Pose pose = pose_of(query_pose);
  RunResult all{};
  measure(names.whole("query"), [&] { all = count_pairs(*pair.a, *pair.b, pose); });
  const bool one = add_first(names, *pair.a, *pair.b, pose);
  PairQuery query(*pair.a, *pair.b, pose);
  (void)query.run(UINT32_MAX, [](const PairQuery::Pair&) { return true; });
  add_count(names.whole("visits"), query.stats().visits);
  add_to_digest(query.stats());
  return all.status == Status::done && query.stats().visits == query_pose.visits &&
         all.count == query_pose.triangle_pairs && one == (all.count != 0);
}

}  // namespace
}  // namespace figures

int main() {
  return figures::measure_others("others", figures::measure_pose);
}
