#include "report/visits.hpp"

#include <algorithm>

#include "flashbvh/algorithm.hpp"
#include "report/sample_poses.hpp"

namespace flashbvh::report {
namespace {

Closeness closeness_of(const tool::WideCounts& counts) {
  if (counts.triangle_pairs != 0) {
    return kIntersecting;
  }
  if (counts.leaf_pairs != 0) {
    return kCloseProximity;
  }
  return counts.overlaps != 0 ? kSmallProximity : kSeparated;
}

void add(Visits& visits, std::uint64_t count) {
  ++visits.poses;
  visits.sum += count;
  visits.most = std::max(visits.most, count);
}

}  // namespace

VisitSample sample_visits(const tool::ImageFile& a, const tool::ImageFile& b, std::size_t poses) {
  const char* const algorithm = tool::default_algorithm(a.layout());
  VisitSample sample;
  sample.wanted = poses;
  std::uint64_t spent = 0;
  for (const Pose& pose : sample_poses(a.tree(), b.tree(), poses)) {
    if (pose.status() != Status::done) {
      continue;
    }
    const tool::Answer answer = tool::collide(a.tree(), b.tree(), pose, algorithm, false);
    const Closeness closeness = closeness_of(answer.counts);
    ++sample.poses;
    add(sample.all[closeness], answer.counts.visits);
    if (closeness == kIntersecting) {
      add(sample.first, tool::collide(a.tree(), b.tree(), pose, algorithm, true).counts.visits);
    }
    spent += answer.counts.visits;
    if (spent >= kMostVisits) {
      break;
    }
  }
  return sample;
}

}  // namespace flashbvh::report
