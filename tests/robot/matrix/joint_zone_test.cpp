// Joint zones: the contact about a joint, the surfaces outside, and the guard's pairs.
#include "robot/matrix/joint_zone.hpp"

#include "flashbvh/clearance.hpp"
#include "robot/matrix/pair_space.hpp"
#include "support/arms/arms.hpp"
#include "support/surface.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

constexpr double kCell = 1e-4;

/// Adds a flat, two-sided fin from two corners of the mesh to a tip.
void add_fin(bake::SourceMesh& mesh, std::uint32_t p, std::uint32_t q, const Vector3& tip) {
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back(tip);
  mesh.triangles.push_back({p, q, last});
  mesh.triangles.push_back({q, p, last});
}

const JointZone& only(const std::vector<JointZone>& zones) {
  REQUIRE(zones.size() == 1);
  return zones[0];
}

/// Two neighbours' zones, and the verdict about their surfaces outside.
struct Decided {
  std::vector<JointZone> zones;
  PairVerdict pair;

  const JointZone& zone() const { return only(zones); }
  double radius() const { return zone().shape.radius; }
  MatrixVerdict verdict() const { return pair.verdict; }
};

struct Neighbours {
  Model model;
  MatrixOptions options;
  ZoneRadii radii;

  FoundZones found() const {
    return joint_zones(model, BakedArm(model, kCell).wholes(), kCell, options, radii);
  }
  std::vector<JointZone> zones(const BakedArm& arm) const {
    return joint_zones(model, arm.wholes(), kCell, options, radii).zones;
  }
  std::vector<JointZone> zones() const { return zones(BakedArm(model, kCell)); }
  JointZone zone() const { return only(zones()); }
  Decided decided() const {
    const BakedArm arm(model, kCell);
    Decided made{zones(arm), {}};
    made.pair = arm.decide(options, made.zones)[0];
    if (made.verdict() == MatrixVerdict::can) {
      CHECK(arm.intersect(0, 1, made.pair.witness));
    }
    return made;
  }
};

/// Two links and the joint between them: it turns about z, or slides along x.
Neighbours joined_by(JointType type, double lower, double upper, const bake::SourceMesh& base,
                     bake::SourceMesh moving) {
  const Transform fixed = type == JointType::prismatic ? turned(1, kPi / 2) : Transform();
  for (Vector3& vertex : moving.vertices) {
    vertex = placed(inverse(fixed), vertex);
  }
  Neighbours made;
  add_link(made.model, kNoJoint, base);
  add_link(made.model, add_joint(made.model, kNoJoint, fixed, type, lower, upper), moving);
  made.model.neighbours = {{0, 1}};
  return made;
}

/// A hub of radius 0.1, a post at a distance of 0.4, and an arm of length 0.5 about the hub.
Neighbours hub_and_arm(double lower, double upper) {
  bake::SourceMesh hub = prism(24, 0.1, 0, 0, -0.1, 0.1);
  append(box({0.4, -0.005, -0.2}, {0.41, 0.005, 0.2}), hub);
  bake::SourceMesh arm = prism(24, 0.11, 0, 0, -0.05, 0.05);
  append(box({0.105, -0.01, -0.02}, {0.5, 0.01, 0.02}), arm);
  return joined_by(JointType::revolute, lower, upper, hub, arm);
}

/// The angle at which the arm's side meets the post's corner (0.4, 0.005), seen from above.
double angle_of_contact() {
  return std::asin(0.01 / std::hypot(0.4, 0.005)) + std::atan2(0.005, 0.4);
}

/// True if a point of the link lies outside the zone, about which its joint turns or shifts it.
bool is_outside(const Model& model, std::size_t link, const JointZone& zone, const Vector3& point) {
  const Transform frame =
      model.links[link].joint == zone.joint ? Transform() : model.joints[zone.joint].fixed;
  return zone.shape.distance_of(placed(inverse(frame), point)) > zone.shape.radius;
}

/// Checks that the bodies contain all of the first link's surface outside the zone, which nothing
/// touches if the second link lies inside.
void check_surface(Random& random, const Model& model, const JointZone& zone) {
  const auto& corners = model.links[zone.b].mesh.vertices;
  if (std::none_of(corners.begin(), corners.end(), [&](const Vector3& corner) {
        return is_outside(model, zone.b, zone, corner);
      })) {
    return;
  }
  for (int i = 0; i < 300; ++i) {
    const Vector3 point = any_point_of(random, model.links[zone.a].mesh);
    const bool is_far = is_outside(model, zone.a, zone, point);
    const bool is_kept = std::any_of(zone.bodies.begin(), zone.bodies.end(), [&](const auto& of) {
      return distance_by_force(point, of.mesh_a) < 1e-9;
    });
    REQUIRE((!is_far || is_kept));
  }
}

/// Checks that if the bodies are near, so are the parts, unless nothing is guarded.
void check_parts(Random& random, const Neighbours& any, const JointZone& zone, bool is_guarded) {
  const auto is_near = [&](const WholeMesh& a, const WholeMesh& b, double value, double distance) {
    const PairSpace space(any.model, {zone.a, a}, {zone.b, b}, kCell);
    return distance == 0 ? space.intersect({value}) : !space.are_apart({value}, distance);
  };
  std::vector<std::pair<BakedPart, BakedPart>> parts;
  for (const ZoneParts& of : zone_parts(any.model, zone, kCell, any.options)) {
    parts.emplace_back(bake_part(of.a, kCell), bake_part(of.b, kCell));
  }
  const Interval range = range_of_variable(any.model, any.model.joints[zone.joint].variable);
  for (int i = 0; i < 100; ++i) {
    const double value = real_between(random, range.lower, range.upper);
    for (const ZoneBodies& bodies : zone.bodies) {
      REQUIRE((!is_near(bodies.a.view(), bodies.b.view(), value, any.options.stop) ||
               (is_guarded && std::any_of(parts.begin(), parts.end(), [&](const auto& of) {
                  return is_near(of.first.view(), of.second.view(), value, any.options.stop + 4);
                }))));
    }
  }
}

}  // namespace

TEST_CASE("what touches about a joint is its zone; what lies outside is decided to 0.001 rad") {
  const double contact = angle_of_contact();
  const Decided can = hub_and_arm(contact - 0.001, 2).decided();
  CHECK((can.zone().a == 0 && can.zone().b == 1 && can.zone().joint == 0));
  CHECK(can.radius() > 0.1);
  CHECK(can.radius() < 0.14);
  CHECK(can.verdict() == MatrixVerdict::can);
  CHECK(can.pair.reason.substr(0, 8) == "outside ");
  CHECK(can.pair.witness[0] < contact);
  CHECK(can.pair.is_guarded);
  const PairVerdict never = hub_and_arm(contact + 0.001, 2).decided().pair;
  CHECK(never.verdict == MatrixVerdict::never);
  CHECK_FALSE(never.is_guarded);
}

/// Each link is one piece: a hub with a fin from two of its corners. The base's fin stands upright
/// at a right angle and reaches out to `tip`. The arm's fin lies flat, 15 degrees wide at its hub,
/// and meets it from an angle of 1.44 on: the end of a range to 1.6, the middle of one to 2.8.
Neighbours fins(double upper, double tip) {
  bake::SourceMesh base = prism(24, 0.1, 0, 0, -0.1, 0.1);
  add_fin(base, 12, 13, {0, tip, 0});
  bake::SourceMesh arm = prism(48, 0.11, 0, 0, -0.05, 0.05);
  add_fin(arm, 3, 95, {0.5, 0, 0});
  return joined_by(JointType::revolute, 0.2, upper, base, arm);
}

TEST_CASE("a fin that a neighbour's fin meets is outside, wherever in the range they meet") {
  for (const double upper : {1.6, 2.8}) {
    CAPTURE(upper);
    const Decided meets = fins(upper, 0.5).decided();
    CHECK(meets.radius() < 0.27);  // 2.25 times what the hubs need
    CHECK(meets.verdict() == MatrixVerdict::can);
    CHECK(meets.pair.share() > 0.01);
  }
  const Decided never = fins(1.3, 0.5).decided();
  CHECK(never.radius() < 0.14);
  CHECK(never.zone().hidden == 0);
  CHECK(never.verdict() == MatrixVerdict::never);
}

TEST_CASE("hulls that touch ever farther from their joint leave it its range, and that is told") {
  const Decided hulls = fins(1.6, 0.3).decided();
  CHECK(hulls.radius() > 0.23);
  CHECK(hulls.radius() < 0.25);
  CHECK(hulls.zone().hidden == Approx((1.6 - 1.44) / 1.4).margin(0.02));
  CHECK(hulls.pair.share() == 0);
  CHECK(hulls.verdict() == MatrixVerdict::never);
}

TEST_CASE("a post of the same piece, beyond a gap, stays guarded") {
  Neighbours post = fins(1.6, 0.2);
  bake::SourceMesh& base = post.model.links[0].mesh;
  base.triangles.resize(base.triangles.size() - 2);
  // Along the floor, then up: at the arm's height from 0.175 on.
  add_fin(base, 12, 14, {0, 0.25, -0.1});
  add_fin(base, 12, static_cast<std::uint32_t>(base.vertices.size() - 1), {0, 0.25, 0.1});
  const Decided is = post.decided();
  CHECK(is.radius() < 0.14);
  CHECK(is.zone().hidden < 0.01);
  CHECK(is.verdict() == MatrixVerdict::can);
  CHECK(is.pair.share() > 0.03);
}

TEST_CASE("neighbours that never touch, but pass within the stop distance, are not guarded") {
  Neighbours passes = hub_and_arm(-1, 1);
  bake::SourceMesh& hub = passes.model.links[0].mesh;
  hub = prism(24, 0.1, 0, 0, -0.1, 0.1);
  append(box({0.3, -0.1, -0.2}, {0.41, 0.1, -0.023}), hub);  // 3 mm below the arm
  CHECK(passes.zone().shape.radius < 0.14);
  passes.options.stop = 0.005 / kCell;
  const Decided are_near = passes.decided();
  CHECK(are_near.radius() > 0.4);
  CHECK(are_near.zone().hidden == 0);
  CHECK_FALSE(are_near.pair.is_guarded);
  CHECK(are_near.pair.share() == 0);
  hub.vertices.back()[2] = 0;  // a corner that the arm meets
  const Decided touch = passes.decided();
  CHECK(touch.radius() < 0.14);
  CHECK(touch.pair.share() > 0.2);
  // Even if they are apart everywhere else.
  passes.model.links[1].mesh = box({0.12, -0.01, -0.02}, {0.5, 0.01, 0.02});
  CHECK(passes.zones().empty());
  hub.vertices.back()[2] = -0.023;
  const Decided are_apart = passes.decided();
  CHECK(are_apart.radius() > 0.4);
  CHECK_FALSE(are_apart.pair.is_guarded);
  passes.options.own = {{0, 1, passes.options.stop, passes.options.stop}};
  const Decided own = passes.decided();
  CHECK(own.zones.empty());
  CHECK(own.pair.is_guarded);
}

TEST_CASE("the zone that is told is exempt, and nothing else") {
  Neighbours chosen = fins(1.6, 0.3);
  Random random = test_random();
  for (const double radius : {0.05, 0.115, 0.15, 0.25}) {
    chosen.radii = {{0, radius}};
    const JointZone zone = chosen.zone();
    REQUIRE(zone.bodies.size() == 1);
    for (const std::size_t side : {0u, 1u}) {
      const bake::SourceMesh& kept = side == 0 ? zone.bodies[0].mesh_a : zone.bodies[0].mesh_b;
      for (int i = 0; i < 200; ++i) {
        REQUIRE(zone.shape.distance_of(any_point_of(random, kept)) > 0.995 * radius);
        const Vector3 point = any_point_of(random, chosen.model.links[side].mesh);
        REQUIRE((zone.shape.distance_of(point) <= radius || distance_by_force(point, kept) < 1e-9));
      }
    }
  }
}

TEST_CASE("a rib that a carriage meets at the end of its rail is outside, to a millimetre") {
  // Rail and rib are one piece, the rib across the end at 0.5. The carriage's front is 0.05 ahead.
  const auto made = [](double upper) {
    bake::SourceMesh ribbed = box({-0.1, -0.05, -0.05}, {0.5, 0.05, 0});
    add_fin(ribbed, 5, 7, {0.5, 0, 0.3});
    return joined_by(JointType::prismatic, 0, upper, ribbed,
                     box({-0.05, -0.04, -0.001}, {0.05, 0.04, 0.2}));
  };
  const Decided meets = made(0.451).decided();
  CHECK(meets.zone().shape.is_cylinder);
  CHECK(meets.radius() < 0.1);
  CHECK(meets.verdict() == MatrixVerdict::can);
  CHECK(made(0.449).decided().verdict() == MatrixVerdict::never);
}

TEST_CASE("what touches between two looks is in the zone") {
  // A gear of 32 teeth on a hub of 64 corners, and a pawl. Over a full turn, 33 samples are as far
  // apart as the teeth: at each sample the pawl is in the middle of a gap.
  constexpr double kTooth = 2 * kPi / 64;
  Neighbours gear = hub_and_arm(kTooth / 2 - kPi, kTooth / 2 + kPi);
  bake::SourceMesh base = prism(24, 0.1, 0, 0, -0.1, 0.1);
  add_fin(base, 0, 1, {0.122, 0, 0.05});
  bake::SourceMesh wheel = prism(64, 0.11, 0, 0, -0.05, 0.05);
  for (std::uint32_t tooth = 0; tooth < 32; ++tooth) {
    const double angle = (2 * tooth + 0.5) * kTooth;
    add_fin(wheel, 4 * tooth + 1, 4 * tooth + 3,
            {0.125 * std::cos(angle), 0.125 * std::sin(angle), 0.05});
  }
  gear.model.links[0].mesh = base;
  gear.model.links[1].mesh = wheel;
  const Decided is = gear.decided();
  CHECK(is.radius() > 0.13);  // 0.121 holds the contact at the samples
  CHECK(is.radius() < 0.16);
  CHECK(is.verdict() == MatrixVerdict::never);
}

TEST_CASE("without time there is no zone, and a guard keeps all that lies outside one") {
  Neighbours late = hub_and_arm(angle_of_contact() - 0.001, 2);
  const JointZone zone = late.zone();
  late.options.deadline = in_seconds(Clock::now(), -1);
  CHECK(late.zones().empty());
  CHECK(late.found().late_joints == std::set<std::size_t>{0});
  late.radii = {{0, 0.2}};
  CHECK(late.zones().empty());
  CHECK(late.found().late_joints == std::set<std::size_t>{0});
  const std::vector<ZoneParts> parts = zone_parts(late.model, zone, kCell, late.options);
  REQUIRE(parts.size() == zone.bodies.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(parts[i].a.triangles.size() == zone.bodies[i].mesh_a.triangles.size());
    CHECK(parts[i].b.triangles.size() == zone.bodies[i].mesh_b.triangles.size());
  }
  // If time runs out in the middle, the remaining surface is kept.
  const auto parts_after = [&](const Deadline& deadline) {
    late.options.deadline = deadline;
    std::size_t triangles = 0;
    for (const ZoneParts& part : zone_parts(late.model, zone, kCell, late.options)) {
      triangles += part.a.triangles.size();
    }
    return triangles;
  };
  CHECK(parts_after(after_looks(8)) > parts_after({}));
}

TEST_CASE("neighbours apart have no zone, late or not, unless they are nearer than they stop") {
  Neighbours apart = hub_and_arm(0.2, 2);
  apart.model.links[1].mesh = box({0.103, -0.01, -0.02}, {0.5, 0.01, 0.02});
  apart.options.deadline = in_seconds(Clock::now(), -1);
  const FoundZones late = apart.found();
  CHECK(late.zones.empty());
  CHECK(late.late_joints.empty());
  apart.options.deadline = {};
  CHECK(apart.zones().empty());
  apart.options.stop = 0.005 / kCell;
  const Decided near = apart.decided();
  REQUIRE(near.zones.size() == 1);
  CHECK(near.verdict() == MatrixVerdict::never);
  apart.options.stop = 0;
  apart.options.own = {{1, 0, 0.005 / kCell, 0.005 / kCell}};
  CHECK(apart.zones().size() == 1);
}

TEST_CASE("joints with two joints between, and links of one joint, have no zone") {
  Neighbours made = hub_and_arm(0, 2);
  made.model.neighbours.clear();
  CHECK(made.zones().empty());
  made.model.neighbours = {{0, 1}};
  made.model.links[1].joint = kNoJoint;
  CHECK(made.zones().empty());
}

TEST_CASE("random neighbours: nothing is lost outside a zone, nor by a guard") {
  std::size_t zones_seen = 0;
  for_rounds(rounds(3, 6), [&](Random& random, int) {
    Neighbours any;
    any.model = any_arm(random, 3);
    for (ModelLink& link : any.model.links) {
      append(box({-0.06, -0.06, -0.06}, {0.06, 0.06, 0.06}), link.mesh);  // touches the next link
    }
    any.options.stop = random.below(2) == 0 ? 0 : 0.004 / kCell;
    const BakedArm arm(any.model, kCell);
    const std::vector<JointZone> zones = any.zones(arm);
    const std::vector<PairVerdict> pairs = arm.decide(any.options, zones);
    for (const JointZone& zone : zones) {
      ++zones_seen;
      check_surface(random, any.model, zone);
      check_parts(random, any, zone, find_pair(pairs, zone.a, zone.b)->is_guarded);
    }
  });
  CHECK(zones_seen > 0);
}
