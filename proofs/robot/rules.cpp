#include "checks.hpp"

namespace robot_check {
namespace {

constexpr std::int64_t kMostCoordinate = 1 << 30;
constexpr std::uint32_t kMostDistance = 8'388'352;
/// The tolerance of a mimic's limits, in units: baking adds three.
constexpr double kMimicMargin = 16;
class Rules {
 public:
  Rules(const Robot& robot, Report& report) : robot_(robot), report_(report) {}

  bool run() {
    if (!check_structure()) {
      return false;
    }
    require(std::isnormal(robot_.cell) && robot_.cell > 0, "cell", "no positive length");
    for (const Joint& joint : robot_.joints) {
      check_joint(joint);
    }
    for (const Pair& pair : robot_.pairs) {
      check_pair(pair);
    }
    for (const Unguarded& pair : robot_.unguarded) {
      check_unguarded(pair);
    }
    check_order(robot_.pairs, "pair");
    check_order(robot_.unguarded, "unguarded pair");
    check_counts();
    for (const Link& link : robot_.links) {
      require(link.mesh.cell_bits == robot_.cell_bits && link.mesh.unit == 5,
              "mesh of link " + link.name, "another cell than the robot's, or not in metres");
    }
    return is_sound_;
  }

 private:
  void require(bool holds, const std::string& row, const std::string& what) {
    if (!holds) {
      report_.refuse(row + ": " + what);
      is_sound_ = false;
    }
  }

  /// Checks the structure that all other checks use.
  bool check_structure() {
    std::uint64_t variables = 0;
    for (std::uint32_t i = 0; i < robot_.joints.size(); ++i) {
      const Joint& joint = robot_.joints[i];
      const std::string row = "joint " + joint.name;
      require(joint.parent < i || joint.parent == kBase, row, "its parent is no joint before it");
      require(joint.variable < robot_.variable_count && joint.variable < 64, row,
              "its variable is none of the robot's");
      require(joint.type <= 2, row, "its type is none");
      require(joint.zeros == 0, row, "not zero where the format wants zeros");
      if (is_sound_ && joint.shift == 0) {
        require((variables >> joint.variable & 1) == 0, row, "moved by another joint's variable");
        variables |= std::uint64_t{1} << joint.variable;
      }
    }
    const std::uint64_t all = robot_.variable_count >= 64
                                  ? ~std::uint64_t{0}
                                  : (std::uint64_t{1} << robot_.variable_count) - 1;
    require(variables == all, "variables", "one has no joint, or there are more than 64");
    for (const Link& link : robot_.links) {
      require(link.joint < robot_.joints.size() || link.joint == kBase, "link " + link.name,
              "its joint is none of the robot's");
      require(link.zero == 0, "link " + link.name, "not zero where the format wants zeros");
    }
    const auto check_links = [&](const auto& pairs) {
      for (const auto& pair : pairs) {
        require(pair.a < pair.b && pair.b < robot_.links.size(), pair_row(pair),
                "its links are not two, in order");
      }
    };
    check_links(robot_.pairs);
    check_links(robot_.unguarded);
    if (is_sound_) {
      check_first_reaches();
    }
    return is_sound_;
  }

  template <class PairType>
  std::string pair_row(const PairType& pair) const {
    return pair.a < robot_.links.size() && pair.b < robot_.links.size()
               ? "pair " + robot_.pair_name(pair.a, pair.b)
               : text("pair of links ", pair.a, " and ", pair.b);
  }

  void check_first_reaches() {
    std::size_t reach = 0;
    for (std::uint32_t i = 0; i < robot_.links.size(); ++i) {
      const Link& link = robot_.links[i];
      require(link.first_reach == reach, "first_reach of link " + robot_.link_name(i),
              text(link.first_reach, ", but the links before it have ", reach));
      reach += robot_.branch(i).size();
    }
    require(robot_.reaches.size() == reach, "reaches",
            text(robot_.reaches.size(), ", but the links' branches have ", reach, " joints"));
  }

  void check_joint(const Joint& joint) {
    const std::string row = "joint " + joint.name;
    const auto is_small = [](std::int64_t value) {
      return value >= -kMostCoordinate && value <= kMostCoordinate;
    };
    require(joint.is_free()
                ? joint.lower == 0 && joint.upper == 0
                : joint.lower <= joint.upper && is_small(joint.lower) && is_small(joint.upper),
            "limits of " + row,
            text(joint.lower, " to ", joint.upper, " are out of order or range"));
    require(joint.shift == 0
                ? joint.multiplier == 1 && joint.offset == 0
                : joint.shift <= 40 && is_small(joint.multiplier) && is_small(joint.offset),
            row, "its multiplier, shift or offset is out of range");
    check_rotation(joint, row);
    if (joint.shift != 0) {
      check_mimic(joint, row);
    }
  }

  void check_rotation(const Joint& joint, const std::string& row) {
    const auto of = [&](int i) { return 0x1p-30 * vec_of(joint.rotation[i]); };
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        worst = std::max(worst, std::fabs(dot(of(i), of(j)) - (i == j ? 1 : 0)));
      }
    }
    require(worst <= 2.001 * 0x1p-30 && dot(cross(of(0), of(1)), of(2)) > 0, "frame of " + row,
            text("no rotation: rows are off by ", worst, " from length 1 and right angles"));
  }

  /// Checks that its limits follow from its master's.
  void check_mimic(const Joint& joint, const std::string& row) {
    const Joint& master = robot_.master(joint.variable);
    require(joint.is_free() == master.is_free(), row, "one of it and its master has no limits");
    const double scale = std::ldexp(joint.multiplier, -static_cast<int>(joint.shift));
    if (joint.is_free()) {
      require(scale == std::floor(scale), row, "turns a part of a turn as its master turns once");
      return;
    }
    const double one = scale * master.lower + joint.offset;
    const double other = scale * master.upper + joint.offset;
    const double low = std::min(one, other);
    const double high = std::max(one, other);
    require(joint.lower <= low + 1 && joint.lower >= low - kMimicMargin &&
                joint.upper >= high - 1 && joint.upper <= high + kMimicMargin,
            "limits of " + row,
            text(joint.lower, " to ", joint.upper, ", but ", master.name, " moves it from ", low,
                 " to ", high));
  }

  void check_pair(const Pair& pair) {
    const std::string row = pair_row(pair);
    require(pair.stop <= pair.warn && pair.warn <= kMostDistance, "distances of " + row,
            text("stop ", pair.stop, ", warn ", pair.warn, ": out of order or range"));
    const Robot::Between between = robot_.between(pair.a, pair.b);
    require(pair.joints_a == between.a.size() && pair.joints_b == between.b.size(),
            "joints of " + row,
            text(pair.joints_a, " and ", pair.joints_b, ", but the tree has ", between.a.size(),
                 " and ", between.b.size()));
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < between.a.size(); ++i) {
      sum += robot_.reaches[robot_.links[pair.a].first_reach + i];
    }
    for (std::size_t i = 0; i < between.b.size(); ++i) {
      sum += robot_.reaches[robot_.links[pair.b].first_reach + i];
    }
    require(pair.reach == sum, "reach of " + row,
            text(pair.reach, ", but its joints' reaches add up to ", sum));
  }

  void check_unguarded(const Unguarded& pair) {
    const std::string row = "unguarded " + pair_row(pair);
    const Robot::Between between = robot_.between(pair.a, pair.b);
    const std::size_t count = between.a.size() + between.b.size();
    require(count > 0, row, "no joint moves the two");
    const std::uint32_t only =
        between.a.empty() ? between.b.empty() ? kBase : between.b[0] : between.a[0];
    require(pair.why == 0   ? count == 1 && pair.joint == only && pair.radius != 0
            : pair.why == 1 ? pair.joint == kBase && pair.radius == 0
                            : false,
            row, "its reason, joint and radius do not agree with the tree");
    for (const Pair& guarded : robot_.pairs) {
      require(guarded.a != pair.a || guarded.b != pair.b, row, "it is guarded, too");
    }
  }

  template <class PairType>
  void check_order(const std::vector<PairType>& pairs, const char* what) {
    for (std::size_t i = 1; i < pairs.size(); ++i) {
      require(std::pair(pairs[i - 1].a, pairs[i - 1].b) < std::pair(pairs[i].a, pairs[i].b),
              what + (" " + robot_.pair_name(pairs[i].a, pairs[i].b)),
              "not in ascending order of links");
    }
  }

  void check_counts() {
    std::uint32_t sum = 0;
    for (const Pair& pair : robot_.pairs) {
      sum += pair.joints_a + pair.joints_b;
    }
    require(sum == robot_.pair_joint_count, "pair_joint_count",
            text(robot_.pair_joint_count, ", but the pairs have ", sum));
  }

  const Robot& robot_;
  Report& report_;
  bool is_sound_ = true;
};

/// The sum of translations, slides and the sphere from base to far side of a link, in cells.
double extent_of(const Robot& robot, std::uint32_t link) {
  const Link& of = robot.links[link];
  double extent = length(vec_of(of.centre)) + of.radius;
  for (const std::uint32_t number : robot.branch(link)) {
    const Joint& joint = robot.joints[number];
    extent += length(vec_of(joint.translation));
    extent +=
        joint.slides() ? std::max(std::fabs(1.0 * joint.lower), std::fabs(1.0 * joint.upper)) : 0;
  }
  return extent / 2048;
}

/// The error of one link's kinematics and rounding, in cells (derivations.md, "Robots").
double error_of(const Robot& robot, std::uint32_t link) {
  const Link& of = robot.links[link];
  const double extent = extent_of(robot, link);
  double error = of.deviation / 256.0 + extent * 0x1p-29 + 1.0 / 2048;
  std::size_t reach = of.first_reach;
  for (const std::uint32_t number : robot.branch(link)) {
    const double units = robot.joints[number].shift == 0 ? 1 : 3;
    error += extent * 0x1p-27 + std::sqrt(3.0) / 2048 +
             units * std::ldexp(robot.reaches[reach++], -26) / 256;
  }
  return error;
}

}  // namespace

bool check_rules(const Robot& robot, Report& report) {
  Rules(robot, report).run();
  return report.end("rules", text(robot.joints.size(), " joints, ", robot.links.size(), " links, ",
                                  robot.pairs.size(), " pairs: limits, frames, mimics, counts, ",
                                  "sums, distances"));
}

void check_spheres(const Robot& robot, Report& report) {
  double nearest = HUGE_VAL;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    const Vec centre = 1.0 / 2048 * vec_of(link.centre);
    double farthest = 0;
    for (const Vec& vertex : link.mesh.vertices) {
      farthest = std::max(farthest, length(vertex - centre));
    }
    count += link.mesh.vertices.size();
    const double left = link.radius / 2048.0 - farthest;
    nearest = std::min(nearest, left);
    if (left < 0) {
      report.refuse(text("sphere of link ", robot.link_name(i), ": radius ", link.radius / 2048.0,
                         " cells, but a vertex is ", farthest,
                         " from its centre: guards pass it over"));
    }
  }
  report.end("spheres", text(robot.links.size(), " links, ", count,
                             " vertices inside; the nearest by ", nearest, " cells"));
}

void check_slack(const Robot& robot, Report& report) {
  double most = 0;
  double far = 0;
  std::uint32_t worst = 0;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const Link& link = robot.links[i];
    far =
        std::max(far, std::fabs(1.0 * link.mesh.origin[0]) + std::fabs(1.0 * link.mesh.origin[1]) +
                          std::fabs(1.0 * link.mesh.origin[2]));
    const double wanted = link.mesh.deviation / robot.cell * 256;
    if (!(link.deviation >= wanted * (1 - 1e-12)) || wanted < 0) {
      report.refuse(text("deviation of link ", robot.link_name(i), ": ", link.deviation,
                         " in 1/256 cell, but its mesh lies ", wanted,
                         " from its source: the slack is too small"));
    }
    if (error_of(robot, i) > most) {
      most = error_of(robot, i);
      worst = i;
    }
  }
  // A placed vertex is off by 0.51 cells along each axis, and by 2^-23 of the farthest origin.
  const double placing = std::max(0.89, std::sqrt(3.0) * (0.51 + far / (1 << 23)));
  // Each deviation is rounded up by less than 1/256 cell.
  const double wanted = (placing + 2 * most) * 256 - 2;
  if (robot.slack < wanted) {
    report.refuse(text("slack: ", robot.slack,
                       " in 1/256 cell, but rounding and kinematics of link ",
                       robot.link_name(worst), " add up to ", wanted, ": guards stop too late"));
  }
  report.end("slack", text(robot.slack, " in 1/256 cell, ", robot.slack - wanted,
                           " more than rounding and kinematics of the worst link"));
}

}  // namespace robot_check
