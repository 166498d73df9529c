#include "robot/matrix/rarity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evaluate/random.hpp"
#include "flashbvh/collide.hpp"

namespace flashbvh::tool {
namespace {

/// Pairs with fewer collisions are sampled again.
constexpr std::uint32_t kFew = 10;
constexpr std::uint32_t kRareFold = 10;

/// Each link's frame.
std::vector<Transform> link_frames(const Model& model, const std::vector<double>& variables) {
  const std::vector<Transform> joints = frames_of(model, variables);
  std::vector<Transform> frames;
  frames.reserve(model.links.size());
  for (const ModelLink& link : model.links) {
    frames.push_back(link.joint == kNoJoint ? Transform() : joints[link.joint]);
  }
  return frames;
}

std::vector<double> any_variables(const Model& model, Random& random) {
  std::vector<double> variables;
  variables.reserve(model.variables.size());
  for (const std::size_t number : model.variables) {
    const ModelJoint& joint = model.joints[number];
    variables.push_back(joint.lower + random.part() * (joint.upper - joint.lower));
  }
  return variables;
}

}  // namespace

BodyTriangles triangles_at(const Model& model, const WholeMesh* meshes, double cell,
                           const PairVerdict& pair) {
  TrianglePair<WholeMesh::Index> found{};
  const Transform frame = frame_between(model, joints_between(model, pair.a, pair.b), pair.witness);
  for (const auto& [a, b] : pair.bodies) {
    if (first_pair(meshes[a], meshes[b], pose_of(frame, cell), found).yes) {
      return {a, b, found};
    }
  }
  return {pair.a, pair.b, found};
}

std::vector<Collisions> collisions_of(const Model& model, const WholeMesh* meshes, double cell,
                                      const std::vector<PairVerdict>& pairs,
                                      std::uint32_t samples) {
  std::vector<Collisions> collisions(pairs.size());
  Random random;
  std::vector<std::size_t> queried;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].verdict == MatrixVerdict::can) {
      queried.push_back(i);
    }
  }
  for (std::uint32_t sample = 0; !queried.empty() && sample < kRareFold * samples; ++sample) {
    if (sample == samples) {
      queried.erase(std::remove_if(queried.begin(), queried.end(),
                                   [&](std::size_t i) { return collisions[i].count >= kFew; }),
                    queried.end());
    }
    const std::vector<Transform> frames = link_frames(model, any_variables(model, random));
    for (const std::size_t i : queried) {
      const auto& [link_a, link_b] = std::pair(pairs[i].a, pairs[i].b);
      const Pose pose = pose_of(composed(inverse(frames[link_a]), frames[link_b]), cell);
      const auto& bodies = pairs[i].bodies;
      collisions[i].count += std::any_of(bodies.begin(), bodies.end(), [&](const auto& of) {
        return intersects(meshes[of.first], meshes[of.second], pose).yes;
      });
      ++collisions[i].of;
    }
  }
  return collisions;
}

Share share_of(const Collisions& collisions) {
  const double samples = collisions.of;
  // The chance of no collision in n samples is 5 % where (1 - p)^n = 0.05.
  return collisions.count == 0 ? Share{1 - std::pow(0.05, 1 / samples), true}
                               : Share{collisions.count / samples, false};
}

double missed_by(std::uint32_t samples, const Share& share) {
  return std::pow(1 - share.part, samples);
}

}  // namespace flashbvh::tool
