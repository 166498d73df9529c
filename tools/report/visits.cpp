#include "report/visits.hpp"

#include <algorithm>

#include "evaluate/queries.hpp"
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

bool is_full(const VisitSample& sample, std::uint64_t wanted) {
  return std::all_of(sample.all.begin(), sample.all.end(),
                     [&](const Visits& visits) { return visits.poses == wanted; });
}

}  // namespace

VisitSample sample_visits(const tool::ImageFile& a, const tool::ImageFile& b,
                          std::uint64_t wanted) {
  const char* const algorithm = default_traversal(a.layout());
  PoseSampler sampler(a.tree(), b.tree());
  VisitSample sample;
  std::uint64_t spent = 0;
  for (std::uint64_t i = 0; i < kTries * wanted && !is_full(sample, wanted); ++i) {
    const Pose pose = sampler.next();
    if (pose.status() != Status::done) {
      ++sample.out_of_range;
      continue;
    }
    // The first pair tells the class; only a pose that is wanted is worth all pairs.
    tool::WideCounts counts = tool::collide(a.tree(), b.tree(), pose, algorithm, true).counts;
    const Closeness closeness = closeness_of(counts);
    spent += counts.visits;
    if (sample.all[closeness].poses < wanted) {
      if (closeness == kIntersecting) {
        add(sample.first, counts.visits);
        counts = tool::collide(a.tree(), b.tree(), pose, algorithm, false).counts;
        spent += counts.visits;
      }
      add(sample.all[closeness], counts.visits);
    }
    if (spent >= kMostVisits) {
      sample.costly = true;
      break;
    }
  }
  return sample;
}

}  // namespace flashbvh::report
