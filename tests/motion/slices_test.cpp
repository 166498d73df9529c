// First contacts in slices: equal answers, also in a new object per slice, and after passed ones.
#include "flashbvh/first_contact.hpp"
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

/// Compares answers, also with wider indices.
template <class Answer>
bool are_same(const FirstContactAnswer& u, const Answer& v) {
  return u.status == v.status && u.outcome == v.outcome && u.from == v.from && u.to == v.to &&
         u.triangles.a == v.triangles.a && u.triangles.b == v.triangles.b;
}

struct Pair {
  Mesh a;
  Mesh b;
  const BodyMotion& motion;
  std::uint32_t within;

  FirstContact query() const { return {a, b, motion, {within}}; }
};

/// All outcomes, passing each `close`; work 0: random slices. `anew`: in a new object for each run.
std::vector<FirstContactAnswer> in_slices(Random& random, const Pair& pair, std::uint32_t work,
                                          bool anew) {
  std::vector<FirstContactAnswer> answers;
  FirstContact::Cursor at = pair.query().cursor();
  FirstContact kept = pair.query();
  std::uint32_t certified = 0;
  for (;;) {
    FirstContact resumed = pair.query();
    if (anew) {
      REQUIRE(resumed.resume(at) == Status::suspended);
    }
    FirstContact& query = anew ? resumed : kept;
    const FirstContactAnswer answer = query.run(work != 0 ? work : 1 + random.below(400));
    REQUIRE((answer.status == Status::done || answer.status == Status::suspended));
    REQUIRE(answer.from >= certified);
    certified = answer.from;
    if (answer.status == Status::done) {
      answers.push_back(answer);
      if (answer.outcome != ContactOutcome::close || answers.size() == 12) {
        return answers;
      }
      REQUIRE((answers.size() == 1 || answer.from >= answers[answers.size() - 2].to));
      query.pass();
    }
    if (query.status() == Status::done) {
      answers.push_back(query.run(1));
      REQUIRE(answers.back().outcome == ContactOutcome::free);
      return answers;
    }
    at = query.cursor();
  }
}

}  // namespace

TEST_CASE("first contacts: the same in any slices, also in another object after each") {
  long passed = 0;
  for_rounds(rounds(150, 10'000) / share_on_board(5), [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const AnyMotion any = any_motion(random, scene);
    const BodyMotion motion =
        random.below(2) == 0 ? any_translation(random, scene).motion() : any.motion();
    const std::uint32_t withins[] = {0, 100, 2000};
    const Pair pair = {scene.a.baked.view(), scene.b.baked.view(), motion,
                       withins[random.below(3)]};
    if (pair.query().status() == Status::motion_out_of_range) {
      return;
    }
    const auto whole = in_slices(random, pair, UINT32_MAX, false);
    passed += static_cast<long>(whole.size()) - 1;
    for (const std::uint32_t work : {1u, 2u, 7u, 33u, 100u, 0u}) {
      for (const bool anew : {false, true}) {
        CAPTURE(work, anew);
        const auto cut = in_slices(random, pair, work, anew);
        REQUIRE(cut.size() == whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i) {
          CAPTURE(i, whole[i].from, whole[i].to, whole[i].triangles.a, whole[i].triangles.b);
          CAPTURE(cut[i].from, cut[i].to, cut[i].triangles.a, cut[i].triangles.b);
          REQUIRE(are_same(whole[i], cut[i]));
        }
      }
    }
  });
  CHECK(passed > 2);
}

TEST_CASE("first contacts: the same of meshes with 32-bit indices") {
  for_rounds(rounds(300, 10'000) / share_on_board(5), 2, [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const AnyMotion any = any_motion(random, scene);
    const BodyMotion motion = any.motion();
    const auto wide = [](const Body& body) {
      return bake::lay_out<std::uint32_t, Layout::post_indexed>(body.tree, body.source);
    };
    const auto wide_a = wide(scene.a);
    const auto wide_b = wide(scene.b);
    const Mesh a = scene.a.baked.view();
    const Mesh b = scene.b.baked.view();
    const Mesh32 a32 = wide_a.view();
    const Mesh32 b32 = wide_b.view();
    const FirstContactAnswer answer = FirstContact(a, b, motion, {50}).run(UINT32_MAX);
    REQUIRE(are_same(answer, BasicFirstContact<Mesh32>(a32, b32, motion, {50}).run(UINT32_MAX)));
  });
}

TEST_CASE("first contacts: what is not close is not passed") {
  for_rounds(100, 1, [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const BodyMotion motion = any_translation(random, scene).motion();
    const Mesh a = scene.a.baked.view();
    const Mesh b = scene.b.baked.view();
    FirstContact query(a, b, motion);
    query.pass();
    const FirstContactAnswer answer = query.run(UINT32_MAX);
    if (answer.outcome != ContactOutcome::close) {
      query.pass();
      REQUIRE(are_same(query.run(UINT32_MAX), answer));
    }
  });
}
