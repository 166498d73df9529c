#include "support/arms/guarded_arm.hpp"

#include <algorithm>

#include "flashbvh/clearance.hpp"

namespace flashbvh::test {
namespace {

JointCoordinate range_of(const FixedArm& arm, std::size_t variable) {
  const RobotJoint& joint = arm.joint_of(variable);
  return arm.is_free(variable) ? kFullTurn : joint.upper - joint.lower;
}

JointCoordinate turned_back(std::int64_t value) {
  return static_cast<JointCoordinate>((value + 5LL * kFullTurn / 2) % kFullTurn - kFullTurn / 2);
}

std::vector<tool::GuardedPair> any_pairs(Random& random, const Model& model, double cell) {
  tool::MatrixOptions options;
  options.most_joint_boxes = 300;
  std::vector<tool::GuardedPair> pairs;
  for (const tool::PairVerdict& pair : BakedArm(model, cell).decide(options)) {
    // Neighbours are not guarded about their joint.
    const bool may = !pair.is_stopped && (pair.verdict == tool::MatrixVerdict::can ||
                                          pair.verdict == tool::MatrixVerdict::undecided);
    const bool is_next = pair.b == pair.a + 1;  // seldom farther apart than their warn distance
    if (may && (!is_next || random.below(6) == 0)) {
      const double stop = random.below(3) == 0 ? 0 : real_between(random, 0, 0.01);
      const double warn = random.below(3) == 0 ? stop : stop + real_between(random, 0, 0.02);
      pairs.push_back({pair.a, pair.b, stop, warn});
    }
  }
  return pairs;
}

}  // namespace

Period::Period(const FixedArm& arm, const Values& before, const Values& now)
    : before_(before), now_(now) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    const std::int64_t way = std::int64_t{now[i]} - before[i];
    now_[i] = arm.is_free(i) ? before[i] + turned_back(way) : now[i];
  }
}

Values Period::between(Random& random) const {
  Values values;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    const std::uint32_t kind = random.below(3);
    const double part = real_between(random, 0, 1);
    values.push_back(kind == 0   ? before_[i]
                     : kind == 1 ? now_[i]
                                 : before_[i] + static_cast<JointCoordinate>(
                                                    part * (double(now_[i]) - before_[i])));
  }
  return values;
}

double Period::travel(const FixedArm& arm, const RobotPair& pair) const {
  double sum = 0;
  for_each_reach(arm.robot(), pair, [&](std::uint32_t joint, double reach) {
    const tool::ModelJoint& of = arm.model.joints[joint];
    const double way = double(now_[of.variable]) - before_[of.variable];
    const double units =
        arm.unit_of(of.variable) / tool::unit_of_coordinate(of.type, arm.arm.cell());
    sum += reach * (std::abs(way * units * of.multiplier) + 3);
  });
  return sum;
}

Wandering::Wandering(const FixedArm& arm, const Values& from, double speed)
    : arm_(arm), values_(from), velocity_(from.size()), manner_(from.size()), speed_(speed) {}

const Values& Wandering::step(Random& random) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double most = speed_ * range_of(arm_, i);
    if (random.below(200) == 0) {
      manner_[i] = random.below(4);
      velocity_[i] = real_between(random, -most, most);
    }
    velocity_[i] = manner_[i] == 0   ? 0
                   : manner_[i] == 1 ? real_between(random, -most, most)
                   : manner_[i] == 2 ? -velocity_[i]
                                     : velocity_[i] + real_between(random, -most, most) / 8;
    velocity_[i] = std::clamp(velocity_[i], -most, most);
    const auto to = static_cast<std::int64_t>(values_[i] + velocity_[i]);
    const RobotJoint& joint = arm_.joint_of(i);
    if (arm_.is_free(i)) {
      values_[i] = turned_back(to);
    } else {
      values_[i] =
          static_cast<JointCoordinate>(std::clamp<std::int64_t>(to, joint.lower, joint.upper));
      velocity_[i] = values_[i] == to ? velocity_[i] : -velocity_[i];
    }
  }
  return values_;
}

FixedArm any_guarded_arm(Random& random, std::size_t joints, double cell) {
  for (;;) {
    const Model model = as_read(any_arm(random, joints));
    const std::vector<tool::GuardedPair> pairs = any_pairs(random, model, cell);
    if (!pairs.empty()) {
      return FixedArm(model, cell, pairs, random.below(2) == 0);
    }
  }
}

bool DrawnArm::is_closer(const RobotPair& pair, const Values& values,
                         std::uint32_t distance) const {
  // In units of the finer cell: the rounding of placing, and half a diagonal of each mesh.
  constexpr std::uint32_t rounded = kPlacingFine + 2 * 222;
  const std::uint32_t fine = std::min(distance, kMaxGuardDistance / kFiner) * kFiner;
  const tool::JointsBetween between = joints_between(arm_.model, pair.a, pair.b);
  const Transform frame = frame_between(arm_.model, between, arm_.variables(values));
  const Answer answer =
      closer_than(drawn_.meshes()[pair.a], drawn_.meshes()[pair.b],
                  tool::pose_of(frame, drawn_.cell()), {fine > rounded ? fine - rounded : 0});
  return fine > rounded && answer.status == Status::done && answer.yes;
}

GuardAnswer prime_apart(Random& random, const FixedArm& arm, Guard& guard, int tries,
                        Values& values) {
  GuardAnswer answer{};
  do {
    values = arm.any_values(random);
    answer = guard.prime(values.data());
  } while (answer.verdict >= Verdict::leaving && tries-- > 0);
  return answer;
}

const char* contradiction(const FixedArm& arm, const DrawnArm& drawn, const GuardAnswer& answer,
                          const Period& period, bool is_unlimited, Random& random) {
  const Robot& robot = arm.robot();
  if (answer.status != Status::done) {
    return "refused";
  }
  const RobotPair& reported = robot.pairs[answer.pair];
  if (is_unlimited && answer.verdict == Verdict::not_yet_known) {
    return "not yet known, with unlimited work";
  }
  const bool is_apart = answer.verdict <= Verdict::warn;
  if ((is_apart && answer.distance <= reported.stop) ||
      (answer.verdict == Verdict::free && answer.distance <= reported.warn)) {
    return "a verdict better than the reported distance";
  }
  if (is_unlimited && answer.verdict == Verdict::stop) {
    // The limit is half of the excess, less at least 1/16 cell.
    const double most = reported.stop + 2.0 * robot.slack + 2 * period.travel(arm, reported) + 40;
    if (most < kMaxGuardDistance &&
        !arm.is_closer(reported, period.at_end(),
                       static_cast<std::uint32_t>(most) + kPlacingFine)) {
      return "stop, too far apart for it";
    }
  }
  for (int moment = 0; moment < 4; ++moment) {
    const Values values = period.at(moment, random);
    if (!holds(robot, answer, [&](const RobotPair& pair, std::uint32_t limit) {
          return drawn.is_closer(pair, values, limit);
        })) {
      return "nearer than the verdict or the distance has it";
    }
  }
  return nullptr;
}

}  // namespace flashbvh::test
