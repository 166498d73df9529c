// Reaches of links from joints, and the motion over a joint box, against samples.
#include "robot/matrix/reaches.hpp"
#include "robot/matrix/pair_space.hpp"
#include "support/arms/arms.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// Raises `found` to the largest distances of the link's vertices from all axes, for one setting.
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

constexpr double kCell = 1e-4;

/// A pair of links of an arm with several joints between them.
struct Pair {
  Model model;
  BakedArm arm;
  std::vector<double> reaches_a;
  std::vector<double> reaches_b;
  PairSpace space;

  explicit Pair(const Model& made, double cell = kCell)
      : model(made),
        arm(model, cell),
        reaches_a(reaches_of(model, 0, cell)),
        reaches_b(reaches_of(model, model.links.size() - 1, cell)),
        space(model, {0, arm.wholes().front(), &reaches_a},
              {model.links.size() - 1, arm.wholes().back(), &reaches_b}, cell) {}
};

}  // namespace

TEST_CASE("nothing that was tried reaches further than the bound") {
  for_rounds(12, [&](Random& random, int) {
    const Model model = any_arm(random, 1 + random.below(5));
    const std::size_t link = random.below(static_cast<std::uint32_t>(model.links.size()));
    const std::vector<double> bounds = reaches_of(model, link, 1e-4);
    std::vector<double> found(model.joints.size());
    for (int i = 0; i < 2000; ++i) {
      take_distances(model, link, any_variables(random, model), found);
    }
    for (std::size_t k = 0; k < found.size(); ++k) {
      CAPTURE(link, k);
      if (model.joints[k].type == JointType::prismatic) {
        CHECK(bounds[k] == 1);
      } else {
        CHECK(found[k] + 0.86 * 1e-4 <= bounds[k]);
      }
    }
  });
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
  // The base's distance from the elbow does not depend on the shoulder.
  add_link(bent, kNoJoint, box({0.5, 0, 0}, {1, 1e-5, 1e-5}));
  near(reaches_of(bent, 1, cell)[elbow], std::sqrt(4 + 0.25 - 2 * std::cos(1.0)));

  // A disc turning about its own axis gets no wider; one that slides across the next axis does.
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

TEST_CASE("beyond twelve joints, and where there is no time, a reach is that of a ball") {
  // The chain stays thin along its own axes at all values. One joint slides, along the chain.
  constexpr double kStep = 0.1;
  constexpr double kSlide = 0.05;
  constexpr std::size_t kSliding = 2;
  Model model;
  std::size_t last = kNoJoint;
  for (std::size_t i = 0; i < 16; ++i) {
    last = add_joint(model, last, shifted({0, 0, kStep}),
                     i == kSliding ? JointType::prismatic : JointType::revolute,
                     i == kSliding ? 0 : -1, i == kSliding ? kSlide : 1);
  }
  add_link(model, last, box({-0.01, -0.01, 0}, {0.01, 0.01, kStep}));
  const std::vector<double> reaches = reaches_of(model, 0, 1e-6);
  const std::vector<double> late = reaches_of(model, 0, 1e-6, in_seconds(Clock::now(), -1));
  for (std::size_t k = 0; k < reaches.size(); ++k) {
    CAPTURE(k);
    if (k == kSliding) {
      CHECK((reaches[k] == 1 && late[k] == 1));
      continue;
    }
    const double ball =
        kStep * static_cast<double>(reaches.size() - k) + (k < kSliding ? kSlide : 0);
    const bool is_ball = k + 12 < reaches.size();
    CHECK(reaches[k] >= (is_ball ? ball : 0.0141));
    CHECK(reaches[k] <= (is_ball ? 1.02 * ball : 0.0145));
    CHECK(late[k] >= ball);
    CHECK(late[k] <= 1.02 * ball);
  }
}

TEST_CASE("links come no nearer in a cell than its motion says") {
  double tightest = 0;
  for_rounds(rounds(20, 40), [&](Random& random, int) {
    const Pair pair(any_arm(random, 2 + random.below(4)));
    for (int i = 0; i < 10; ++i) {
      std::vector<double> middle;
      std::vector<double> halves;
      for (const Dimension& dimension : pair.space.dimensions()) {
        const Interval& range = dimension.range;
        const double width = range.upper - range.lower;
        middle.push_back(range.lower + real_between(random, 0.1, 0.9) * width);
        halves.push_back(real_between(random, 0, 0.05) * width);
      }
      const double bound = pair.space.motion(middle, halves).sum + 2 * kPlacing;
      PairSpace::Hint seed;
      const double before = pair.space.distance(middle, seed);
      for (int k = 0; k < 60; ++k) {
        std::vector<double> point = middle;
        for (std::size_t d = 0; d < point.size(); ++d) {
          // Corners of the joint box, which move most.
          point[d] += random.below(2) == 0 ? halves[d] : -halves[d];
        }
        const double after = pair.space.distance(point, seed);
        REQUIRE(std::fabs(after - before) <= bound + 1);
        tightest = std::max(tightest, std::fabs(after - before) / bound);
      }
    }
  });
  CAPTURE(tightest);
  CHECK(tightest > 0.6);  // a weaker bound would show little
}

TEST_CASE("the motion of a cell: formulas") {
  // A large plate and a rod of length 1 on an upper arm of length 2, folded to a right angle.
  Model model;
  add_link(model, kNoJoint, box({-50, -50, -0.1}, {50, 50, 0}));
  const std::size_t shoulder =
      add_joint(model, kNoJoint, shifted({0, 0, 1}), JointType::revolute, -1, 1);
  const std::size_t elbow =
      add_joint(model, shoulder, shifted({2, 0, 0}), JointType::revolute, -kPi, kPi);
  add_link(model, elbow, box({0, 0, 0}, {1, 0.01, 0.01}));
  const double cell = 4e-3;
  const Pair pair(model, cell);
  const PairSpace& space = pair.space;
  REQUIRE(space.dimensions()[0].variable == 0);
  const Motion motion = space.motion({0, kPi / 2}, {0.1, 0.2});
  CHECK(motion.parts[0] * cell == Approx(0.1 * std::sqrt(5.0)).epsilon(0.01));
  CHECK(motion.parts[1] * cell == Approx(0.2).epsilon(0.01));
  CHECK(motion.sum == Approx(motion.parts[0] + motion.parts[1]));
  // Stretched out, the rod reaches further.
  CHECK(space.motion({0, 0}, {0.1, 0.2}).parts[0] * cell == Approx(0.3).epsilon(0.01));
}
