// Tools and obstacles added to random arms, guarded and certified, against brute force.
#include "flashbvh/clearance.hpp"
#include "flashbvh/robot/motion.hpp"
#include "flashbvh/shape.hpp"
#include "support/arms/any_workcell.hpp"
#include "support/test.hpp"

using namespace flashbvh::tool;

namespace {

/// Whether brute force contradicts a promise of the answer.
bool is_contradicted(const CrowdedCell& cell, const GuardAnswer& answer, const Period& period,
                     Random& random) {
  bool is = false;
  for (int moment = 0; !is && moment < 4; ++moment) {
    const double part = moment == 0 ? 0 : moment == 1 ? 1 : real_between(random, 0, 1);
    const Values values = period.at(moment, random);
    is = !holds(cell.robot(), answer, [&](const RobotPair& pair, std::uint32_t limit) {
      return limit > kPlacingFine && cell.is_closer(pair, values, part, limit - kPlacingFine);
    });
  }
  return is;
}

}  // namespace

TEST_CASE("tools and obstacles are guarded as links are, whatever the budget") {
  constexpr std::uint32_t budgets[] = {1, 8, 100, UINT32_MAX};
  for_rounds(rounds(5, 10), [&](Random& random, int round) {
    Values before;
    const auto cell = any_cell_apart(random, before);
    const auto state = std::make_unique<WorkcellState>();
    Guard guard(cell->robot(), *state);
    const std::uint32_t work = budgets[round % 4];
    const double speed = random.below(2) == 0 ? 1e-3 : 2e-2;
    GuardAnswer answer = guard.prime(before.data());
    REQUIRE(answer.verdict <= Verdict::warn);
    REQUIRE_FALSE(is_contradicted(*cell, answer, Period(cell->arm, before, before), random));
    Wandering wandering(cell->arm, before, speed);
    for (int i = 0; i < 60; ++i) {
      CAPTURE(i, work);
      const Values now = wandering.step(random);
      if (i % 10 != 9) {
        REQUIRE(cell->move(random, speed) == Status::done);
      } else {  // the obstacle stands still
        cell->way = {cell->way.at(1), {}, 0, 0};
      }
      answer = guard.update(now.data(), work);
      REQUIRE(answer.status == Status::done);
      REQUIRE_FALSE(is_contradicted(*cell, answer, Period(cell->arm, before, now), random));
      before = now;
      if (random.below(8) == 0) {
        REQUIRE(guard.resume() == Status::done);
      }
    }
    cell->put_on_a_link(before);
    guard.forget();
    CHECK(guard.update(before.data(), 0).verdict == Verdict::not_yet_known);
    CHECK(guard.go_on(UINT32_MAX).verdict == Verdict::stop);
  });
}

TEST_CASE("no joint moves a tool farther than its reach") {
  for_rounds(4, [&](Random& random, int) {
    const auto cell = std::make_unique<CrowdedCell>(random);
    const Robot& robot = cell->robot();
    const RobotLink& tool = robot.links[cell->links[0]];
    const std::vector<Vector3> vertices = vertices_of(robot.meshes[cell->links[0]]);
    for (int i = 0; i < 200; ++i) {
      const Values values = cell->arm.any_values(random);
      const std::vector<Transform> frames = frames_of(cell->arm.model, cell->arm.variables(values));
      const Transform tool_frame = composed(frames[cell->tool_joint], cell->tool_at);
      const Vector3& v = vertices[random.below(static_cast<std::uint32_t>(vertices.size()))];
      const Vector3 at =
          placed(tool_frame, {v[0] * kWorkcellCell, v[1] * kWorkcellCell, v[2] * kWorkcellCell});
      const std::uint32_t* reach = robot.reaches + tool.first_reach + 1;
      for (std::size_t j = cell->tool_joint; j != kNoJoint; j = cell->arm.model.joints[j].parent) {
        const Vector3 seen = placed(inverse(frames[j]), at);
        const JointType type = cell->arm.model.joints[j].type;
        const double lever =
            type == JointType::prismatic ? 1 : std::hypot(seen[0], seen[1]) / kWorkcellCell;
        REQUIRE(std::ldexp(*reach++, -kReachBits) >= lever * unit_of_coordinate(type, 1) * 256);
      }
    }
  });
}

TEST_CASE("a body adds as much slack as a link that is baked there, with far joints and origins") {
  struct Row {
    double joints_apart, origin_of_link, origin_of_body;  // in metres
  };
  std::uint32_t near_added = 0;
  std::uint32_t near_baked = 0;
  for (const Row& row : {Row{0, 0, 0}, {80, 0, 0}, {0, 600, 0}, {0, 0, 600}, {0, 600, 600}}) {
    CAPTURE(row.joints_apart, row.origin_of_link, row.origin_of_body);
    const auto cube = [](double at) { return box({at, at, at}, {at + 1, at + 1, at + 1}); };
    Model model;
    add_link(model, kNoJoint, cube(row.origin_of_link));
    for (std::size_t joint = 0; joint < 5; ++joint) {
      add_joint(model, joint == 0 ? kNoJoint : joint - 1, shifted({row.joints_apart, 0, 0}),
                JointType::revolute, -1, 1);
    }
    Model of_body;
    add_link(of_body, kNoJoint, cube(row.origin_of_body));
    const BakedArm body(of_body, kWorkcellCell);
    const bool is_tool = row.origin_of_body == 0;
    const Mount mount = {is_tool ? std::uint8_t{4} : kBase, kIdentityFrame};
    const FixedArm arm(model, kWorkcellCell);
    const auto memory = std::make_unique<AnyWorkcell>();
    Workcell workcell(arm.robot(), *memory);
    std::uint8_t link = 0;
    REQUIRE(workcell.add(body.meshes()[0], mount, link) == Status::done);
    add_link(model, is_tool ? 4 : kNoJoint, cube(row.origin_of_body));
    const std::uint32_t baked = FixedArm(model, kWorkcellCell).robot().slack;
    const std::uint32_t added = workcell.robot().slack;
    near_added = near_added == 0 ? added : near_added;
    near_baked = near_baked == 0 ? baked : near_baked;
    CAPTURE(added, near_added, baked, near_baked);
    CHECK(added >= baked);
    CHECK(added - near_added + 3 >= baked - near_baked);  // both are rounded
    CHECK(added - near_added <= 8 * (baked - near_baked));
    // Links that deviate by 45/256 cell more than these.
    Robot coarse = arm.robot();
    coarse.slack += 2 * 45;
    Workcell with_coarse(coarse, *memory);
    REQUIRE(with_coarse.add(body.meshes()[0], mount, link) == Status::done);
    CHECK(with_coarse.robot().slack >= baked + 45);
  }
}

namespace {

/// A mesh as `bake` makes it with the workcell's cell.
BakedMesh baked_body(const bake::SourceMesh& mesh, double simplify, bool drop) {
  const InputMesh input = input_of("", mesh, degenerate_triangles(mesh));
  BakeOptions options;
  options.cell = kWorkcellCell;
  options.drop_degenerate = drop;
  if (simplify == 0) {
    return flashbvh::tool::bake(input, options);
  }
  simplify::Coarsening coarse(mesh, kWorkcellCell);
  coarse.coarsen(simplify);
  return flashbvh::tool::bake(input, options, coarse);
}

Mesh view_of(const BakedMesh& baked) {
  return std::get<bake::BakedTree<std::uint16_t, Layout::post_indexed>>(baked.tree).view();
}

/// A plate, and a part of it that reaches 0.2 upwards: a tip, or a needle of a tenth of a cell.
bake::SourceMesh plate(bool has_needle) {
  bake::SourceMesh mesh;
  mesh.vertices = {{-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0.3, 0.3, 0}, {-0.3, 0.3, 0}, {0, 0, 0.2}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  if (has_needle) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 0}, {kWorkcellCell / 10, 0, 0}});
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {5, 6, 4}};
  }
  return mesh;
}

}  // namespace

TEST_CASE("a body is kept as far away as its file's mesh, simplified or with triangles dropped") {
  Model model;
  add_joint(model, kNoJoint, Transform(), JointType::revolute, -1, 1);
  add_link(model, kNoJoint, box({-0.1, -0.1, 4}, {0.1, 0.1, 4.2}));
  add_link(model, 0, box({-0.1, -0.1, 0}, {0.1, 0.1, 0.2}));
  const FixedArm arm(model, kWorkcellCell);
  constexpr std::uint32_t kStop = 10 << 8;
  for (const bool is_dropped : {false, true}) {
    const bake::SourceMesh source = plate(is_dropped);
    const BakedMesh whole = baked_body(source, 0, false);
    const BakedMesh baked = baked_body(source, is_dropped ? 0 : 0.21, is_dropped);
    const Mesh body = view_of(baked);
    REQUIRE(body.triangle_count == 2);
    bool verdicts[6] = {};
    for (int apart = -10; apart <= 320; apart += 10) {
      CAPTURE(is_dropped, apart);
      AnyWorkcell memory;
      Workcell workcell(arm.robot(), memory);
      Frame frame = kIdentityFrame;
      frame.translation[2] = (-100 - apart) * kFrameCell;  // the tip is 100 cells above the plate
      std::uint8_t link = 0;
      REQUIRE(workcell.add(body, {kBase, frame}, link) == Status::done);
      REQUIRE(workcell.keep_apart(1, link, {kStop}, {kStop}) == Status::done);
      WorkcellState state;
      Guard guard(workcell.robot(), state);
      const JointCoordinate value = 0;
      const Verdict verdict = guard.prime(&value).verdict;
      const Pose at = Pose::translated(0, 0, -100 - apart);
      REQUIRE((verdict > Verdict::warn ||
               !closer_than(arm.robot().meshes[1], view_of(whole), at, {kStop}).yes));
      verdicts[static_cast<int>(verdict)] = true;
    }
    CHECK(verdicts[static_cast<int>(Verdict::free)]);
    CHECK(verdicts[static_cast<int>(Verdict::leaving)]);
  }
}

TEST_CASE("a shape counts as rounded to the nearest cell") {
  Model model;
  add_joint(model, kNoJoint, {}, JointType::revolute, -1, 1);
  add_link(model, kNoJoint, box({-1, -1, -1}, {1, 1, 1}));
  const FixedArm arm(model, kWorkcellCell);
  AnyWorkcell memory;
  Workcell workcell(arm.robot(), memory);
  const BoxShape shape(arm.robot().meshes[0], {0, 0, 0}, {10, 10, 10});
  std::uint8_t link = 0;
  REQUIRE(workcell.add(shape.mesh(), {kBase, kIdentityFrame}, link) == Status::done);
  CHECK(memory.links[link].deviation >= std::sqrt(0.75) * 256);
}

TEST_CASE("motions are certified with tools and obstacles in the way") {
  for_rounds(rounds(6, 16), [&](Random& random, int round) {
    Values from;
    const auto cell = any_cell_apart(random, from);
    MotionStateOf<12, 12> state{};
    MotionQuery query(cell->robot(), state);
    Values to = cell->arm.any_values(random);
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = round % 3 == 0 ? from[i] : from[i] + (to[i] - from[i]) / 16;
    }
    REQUIRE(query.start(from.data(), to.data()) == Status::done);
    const MotionAnswer answer = query.run(UINT32_MAX);
    REQUIRE(answer.status == Status::done);
    CHECK((round % 3 != 0 || answer.outcome == MotionOutcome::free));  // stands still
    for (int i = 0; answer.outcome == MotionOutcome::free && i < 40; ++i) {
      Values values(from.size());
      query.set_values(random.below((1 << 20) + 1), 20, values.data());
      for (std::uint32_t k = 0; k < cell->robot().pair_count; ++k) {
        REQUIRE_FALSE(cell->is_closer(cell->robot().pairs[k], values, 1, 0));
      }
    }
    cell->put_on_a_link(to);
    REQUIRE(query.start(from.data(), to.data()) == Status::done);
    CHECK(query.run(UINT32_MAX).outcome != MotionOutcome::free);
  });
}

TEST_CASE("what a workcell refuses changes nothing") {
  Random random(test_seed());
  const auto cell = std::make_unique<CrowdedCell>(random);
  const Robot& robot = cell->robot();
  const Robot before = robot;
  const Mesh& mesh = cell->tool.mesh();
  std::uint8_t link = 77;
  Frame frame = kIdentityFrame;
  const auto carriers = static_cast<std::uint8_t>(robot.joint_count - 1);
  CHECK(cell->workcell.add(mesh, {carriers, frame}, link) == Status::link_invalid);
  Mesh other = mesh;
  other.cell_bits ^= 1;
  CHECK(cell->workcell.add(other, {kBase, frame}, link) == Status::cell_mismatch);
  other = mesh;
  other.deviation_sixteenths = kDeviationUnknown;
  CHECK(cell->workcell.add(other, {kBase, frame}, link) == Status::distance_out_of_range);
  frame.translation[1] = kMaxFrameTranslation;
  CHECK(cell->workcell.add(mesh, {kBase, frame}, link) == Status::translation_out_of_range);
  CHECK(cell->workcell.move(cell->links[2], frame, {0}) == Status::translation_out_of_range);
  frame = kIdentityFrame;
  frame.rotation[2][2] = -kRotationOne;
  CHECK(cell->workcell.add(mesh, {kBase, frame}, link) == Status::not_a_rotation);
  CHECK(cell->workcell.move(cell->links[2], frame, {0}) == Status::not_a_rotation);
  other = mesh;
  other.origin[0] = INT32_MAX;
  other.cell_bits = mesh.cell_bits;
  CHECK(cell->workcell.add(other, {kBase, kIdentityFrame}, link) ==
        Status::translation_out_of_range);
  CHECK(cell->workcell.move(cell->links[2], kIdentityFrame, {1u << 28}) ==
        Status::distance_out_of_range);
  CHECK(cell->workcell.move(cell->links[0], kIdentityFrame, {0}) == Status::link_invalid);
  CHECK(cell->workcell.move(0, kIdentityFrame, {0}) == Status::link_invalid);
  CHECK(cell->workcell.move(robot.link_count, kIdentityFrame, {0}) == Status::link_invalid);
  CHECK(cell->workcell.keep_apart(0, robot.link_count, {0}, {0}) == Status::link_invalid);
  CHECK(cell->workcell.keep_apart(1, 1, {0}, {0}) == Status::link_invalid);
  CHECK(cell->workcell.keep_apart(0, cell->links[0], {9}, {8}) == Status::distance_out_of_range);
  CHECK(cell->workcell.keep_apart(0, cell->links[0], {0}, {kMaxGuardDistance + 1}) ==
        Status::distance_out_of_range);
  CHECK(std::memcmp(&before, &robot, sizeof before) == 0);
  CHECK(link == 77);

  WorkcellOf<3, 3, 1, 4> small;
  Workcell tiny(cell->arm.robot(), small);
  CHECK(tiny.add(mesh, {kBase, kIdentityFrame}, link) == Status::workcell_full);
  CHECK(tiny.robot().joints == cell->arm.robot().joints);  // the guard keeps all its pairs
  CHECK(tiny.robot().pair_count == cell->arm.robot().pair_count);

  Robot late = cell->arm.robot();
  late.slack = kMaxGuardDistance;
  const auto memory = std::make_unique<AnyWorkcell>();
  Workcell last(late, *memory);
  REQUIRE(last.add(mesh, {kBase, kIdentityFrame}, link) == Status::done);
  other.deviation_sixteenths = 1;
  other.origin[0] = 1 << 18;
  CHECK(last.add(other, {kBase, kIdentityFrame}, link) == Status::distance_out_of_range);
}

TEST_CASE("an obstacle that comes nearer is as near as the guard says, whatever the budget") {
  Random random(test_seed());
  Model model;
  add_joint(model, kNoJoint, Transform(), JointType::revolute, -1, 1);
  add_link(model, kNoJoint, box({1, -1, -1}, {1.2, 1, 1}));
  add_link(model, 0, box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, kWorkcellCell);
  const Body body(random);
  for (const std::uint32_t work : {0u, 1u, 20u, 1000u}) {
    for (const std::uint32_t most : {2000u, 100u}) {
      CAPTURE(work, most);
      AnyWorkcell memory;
      Workcell workcell(arm.robot(), memory);
      std::uint8_t link = 0;
      REQUIRE(workcell.add(body.mesh(), {kBase, kIdentityFrame}, link) == Status::done);
      REQUIRE(workcell.keep_apart(0, link, {500}, {2000}) == Status::done);
      // A unit of the joint's coordinate is 1/256 cell and moves the obstacle by 1/256 cell.
      REQUIRE(memory.reaches[memory.links[link].first_reach] == 1u << kReachBits);
      WorkcellState state;
      Guard guard(workcell.robot(), state);
      const JointCoordinate value = 0;
      Frame frame = kIdentityFrame;
      GuardAnswer answer = guard.prime(&value);
      double left = 1e9;
      long verdicts[6] = {};
      while (left > 0 && answer.verdict != Verdict::stop) {
        const std::uint32_t moved = random.below(left < 5000 ? most / 4 + 1 : most);
        frame.translation[0] += static_cast<std::int32_t>(moved) * 8;
        REQUIRE(workcell.move(link, frame, {moved + moved / 3}) == Status::done);  // overstated
        answer = guard.update(&value, work);
        const double at = (body.low[0] + body.size[0]) / kWorkcellCell + 0.5;
        left = (1 / kWorkcellCell - at) * 256 - frame.translation[0] / 8.0;
        CAPTURE(left, answer.distance, static_cast<int>(answer.verdict));
        REQUIRE(answer.distance <= std::max(left + 256, 0.0));
        REQUIRE((answer.verdict > Verdict::warn || left > 500 - 256));
        REQUIRE((answer.verdict != Verdict::free || left > 2000 - 256));
        // Its box warns, not its sphere.
        REQUIRE((work < 1000 || answer.verdict == Verdict::free ||
                 left < 2000 + 2 * moved + 2 * workcell.robot().slack + 256));
        ++verdicts[static_cast<int>(answer.verdict)];
      }
      CHECK(answer.verdict >= (work < 1000 ? Verdict::not_yet_known : Verdict::stop));
      CHECK((work < 1000 || (verdicts[0] > 0 && verdicts[1] > 0)));
    }
  }
}
