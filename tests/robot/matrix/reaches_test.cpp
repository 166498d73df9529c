// How far links reach from joints, against settings that were tried.
#include "robot/matrix/reaches.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "support/arms/arms.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using namespace flashbvh::test;

namespace {

/// The largest distances from all axes of the link's vertices, of one setting.
void take_distances(const Model& model, std::size_t link, const std::vector<double>& variables,
                    std::vector<double>& found) {
  const std::vector<Transform> frames = frames_of(model, variables);
  const std::size_t joint = model.links[link].joint;
  const Transform own = joint == kNoJoint ? Transform() : frames[joint];
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Transform seen = composed(inverse(frames[k]), own);
    for (const Vector3& vertex : model.links[link].mesh.vertices) {
      const Vector3 p = placed(seen, vertex);
      found[k] = std::max(found[k], std::hypot(p[0], p[1]));
    }
  }
}

/// A link of the arm's and settings of all joints, of which some are at their ends.
std::vector<double> found_by_trial(Random& random, const Model& model, std::size_t link,
                                   int tries) {
  std::vector<double> found(model.joints.size());
  for (int i = 0; i < tries; ++i) {
    take_distances(model, link, any_variables(random, model), found);
  }
  return found;
}

}  // namespace

TEST_CASE("nothing that was tried reaches further than the bound") {
  CAPTURE(test_seed());
  Random random(test_seed());
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    const Model model = any_arm(random, 1 + random.below(5));
    const std::size_t link = random.below(static_cast<std::uint32_t>(model.links.size()));
    const std::vector<double> bounds = reaches_of(model, link, 1e-4);
    const std::vector<double> found = found_by_trial(random, model, link, 2000);
    for (std::size_t k = 0; k < found.size(); ++k) {
      CAPTURE(link, k);
      if (model.joints[k].type == JointType::prismatic) {
        CHECK(bounds[k] == 1);
      } else {
        CHECK(found[k] + 0.86 * 1e-4 <= bounds[k]);
      }
    }
  }
}

TEST_CASE("reaches are tight: formulas") {
  const double cell = 1e-6;
  const double margin = 0.005;
  const auto near = [&](double bound, double truth) {
    CHECK(bound >= truth);
    CHECK(bound <= truth * (1 + margin));
  };
  // A rod of length 1 on a forearm of length 2, in a plane; the elbow bends from 60 to 120 degrees.
  Model bent;
  const std::size_t shoulder = add_joint(bent, kNoJoint, {}, JointType::revolute, -1, 1);
  const std::size_t elbow =
      add_joint(bent, shoulder, shifted({2, 0, 0}), JointType::revolute, kPi / 3, 2 * kPi / 3);
  add_link(bent, elbow, box({0, 0, 0}, {1, 1e-5, 1e-5}));
  std::vector<double> reaches = reaches_of(bent, 0, cell);
  near(reaches[elbow], 1);
  near(reaches[shoulder],
       std::sqrt(4 + 1 + 2.0));  // by the cosine of 60 degrees; 3 if it were free
  // From the base: how far it lies from the elbow, whatever the shoulder does.
  add_link(bent, kNoJoint, box({0.5, 0, 0}, {1, 1e-5, 1e-5}));
  near(reaches_of(bent, 1, cell)[elbow], std::sqrt(4 + 0.25 - 2 * std::cos(1.0)));

  // A disc about its own axis is no wider for turning; one that slides across the next axis is.
  Model slid;
  const std::size_t turning = add_joint(slid, kNoJoint, {}, JointType::revolute, -9, 9);
  const std::size_t sliding =
      add_joint(slid, turning, turned(1, kPi / 2), JointType::prismatic, -0.5, 2);
  const std::size_t spinning =
      add_joint(slid, sliding, turned(1, -kPi / 2), JointType::continuous, -kPi, kPi);
  add_link(slid, spinning, prism(64, 0.25, 0, 0, 0, 3));
  reaches = reaches_of(slid, 0, cell);
  near(reaches[spinning], 0.25);
  CHECK(reaches[sliding] == 1);
  near(reaches[turning], 2.25);
}

TEST_CASE("a mimic reaches as far as its master's limits let it") {
  Model model;
  const std::size_t master = add_joint(model, kNoJoint, {}, JointType::revolute, 0, 0.375);
  const std::size_t mimic =
      add_mimic(model, master, shifted({1, 0, 0}), JointType::revolute, 0, -4, kPi);
  add_link(model, mimic, box({0, 0, 0}, {1, 1e-5, 1e-5}));
  // The rod turns from pointing back, at pi, to pi - 1.5: it never stretches out.
  const double truth = std::sqrt(1 + 1 + 2 * std::cos(kPi - 1.5));
  const double bound = reaches_of(model, 0, 1e-6)[master];
  CHECK(bound >= truth);
  CHECK(bound <= 1.01 * truth);
}
