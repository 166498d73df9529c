// First contacts in slices, from cursors and from motions of any numbers.
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

using Cursor = FirstContact::Cursor;

/// Compares answers, also with wider indices.
template <class Answer>
bool are_same(const FirstContactAnswer& u, const Answer& v) {
  return u.status == v.status && u.outcome == v.outcome && u.from == v.from && u.to == v.to &&
         u.triangles.a == v.triangles.a && u.triangles.b == v.triangles.b;
}

/// All outcomes, passing each `close`; work 0: random slices. `anew`: in a new object for each run.
std::vector<FirstContactAnswer> in_slices(Random& random, const Encounter& of, std::uint32_t work,
                                          bool anew) {
  std::vector<FirstContactAnswer> answers;
  FirstContact query = of.query();
  std::uint32_t certified = 0;
  while (answers.size() < 12) {
    const FirstContactAnswer answer = query.run(work != 0 ? work : 1 + random.below(400));
    REQUIRE(answer.from >= certified);
    certified = answer.from;
    if (answer.status == Status::done) {
      answers.push_back(answer);
      query.pass();
      if (answer.outcome != ContactOutcome::close) {
        REQUIRE(are_same(query.run(UINT32_MAX), answer));  // only `close` is passed
        break;
      }
    }
    FirstContact other = of.query();
    REQUIRE(other.resume(query.cursor()) ==
            (query.status() == Status::suspended ? Status::suspended : Status::cursor_invalid));
    if (query.status() == Status::done) {  // passed at the end
      answers.push_back(query.run(1));
      break;
    }
    query = anew ? other : query;
  }
  return answers;
}

Cursor corrupted(Random& random, const Cursor& cursor) {
  unsigned char bytes[sizeof(Cursor)];
  std::memcpy(bytes, &cursor, sizeof bytes);
  for (std::uint32_t i = random.below(random.below(8) == 0 ? 60 : 4) + 1; i-- > 0;) {
    const auto any = static_cast<unsigned char>(random.next());
    bytes[random.below(sizeof bytes)] = random.below(2) == 0 ? 0 : any;
  }
  Cursor made;
  std::memcpy(&made, bytes, sizeof made);
  return made;
}

/// A cursor with possible times and phases.
Cursor plausible(Random& random, Cursor cursor) {
  cursor.status = Status::suspended;
  cursor.phase = static_cast<ContactPhase>(random.below(4));
  cursor.time = random.below(3) == 0 ? kMotionEnd : random.below(kMotionEnd) & ~1u;
  cursor.step = random.below(3) == 0 ? 0 : random.below(kMotionEnd + 1 - cursor.time) & ~1u;
  cursor.near_since = random.below(2) == 0 ? Cursor::kNever : random.below(cursor.time + 1);
  cursor.near_steps = static_cast<std::uint8_t>(random.next());
  return cursor;
}

/// A number that is small, near a power of two, or random.
int32_t extreme(Random& random) {
  const auto power = static_cast<int32_t>(1u << random.below(31));
  const int32_t near = power - 1 + random.between(-1, 1);
  const int32_t small = random.between(-3, 3);
  const int32_t numbers[] = {small, near, -near, static_cast<int32_t>(random.next())};
  return random.one_of(numbers);
}

/// A coordinate of a mesh or a pose, mostly in range.
int32_t any_cells(Random& random) {
  return random.below(3) != 0 ? random.between(-300, 300) : extreme(random) >> random.below(14);
}

Move extreme_move(Random& random, const MotionScene& scene) {
  Move move = any_move(random, scene.size, scene.size);
  int32_t numbers[10];
  static_assert(sizeof numbers == sizeof move);
  std::memcpy(numbers, &move, sizeof move);
  for (uint32_t i = random.below(4); i-- > 0;) {
    numbers[random.below(10)] = extreme(random);
  }
  std::memcpy(&move, numbers, sizeof move);
  return move;
}

Pose extreme_pose(Random& random) {
  int32_t cells[3];
  int16_t fraction[3];
  for (int i = 0; i < 3; ++i) {
    cells[i] = any_cells(random);
    fraction[i] = static_cast<int16_t>(random.next());
  }
  return Pose::rigid(rotation_of(any_quaternion(random)).entry, cells, fraction);
}

}  // namespace

TEST_CASE("first contacts: the same in slices, in another object after each, with 32-bit indices") {
  std::size_t passed = 0;
  for_rounds(rounds(150, 10'000), [&](Random& random, int) {
    const Encounter of(random);
    if (!of.is_in_range()) {
      return;
    }
    const auto whole = in_slices(random, of, UINT32_MAX, false);
    passed += whole.size() - 1;
    for (const std::uint32_t work : {1u, 2u, 7u, 33u, 100u, 0u}) {
      for (const bool anew : {false, true}) {
        CAPTURE(work, anew);
        const auto cut = in_slices(random, of, work, anew);
        REQUIRE(std::equal(cut.begin(), cut.end(), whole.begin(), whole.end(),
                           are_same<FirstContactAnswer>));
      }
    }
    const auto wide = [](const Body& body) {
      return bake::lay_out<std::uint32_t, Layout::post_indexed>(body.tree, body.source);
    };
    const auto wide_a = wide(of.scene.a);
    const auto wide_b = wide(of.scene.b);
    const Mesh32 a = wide_a.view();
    const Mesh32 b = wide_b.view();
    BasicFirstContact<Mesh32> query(a, b, of.motion, {of.within});
    REQUIRE(are_same(whole[0], query.run(UINT32_MAX)));
  });
  CHECK(passed > 2);
}

TEST_CASE("first contacts: any numbers for a cursor are refused or lead to an end") {
  long taken = 0;
  long refused = 0;
  for_rounds(rounds(100, 5'000), 1, [&](Random& random, int) {
    const Encounter of(random);
    for (int i = 0; of.is_in_range() && i < 100; ++i) {
      CAPTURE(i);
      FirstContact before = of.query();
      (void)before.run(1 + random.below(2000));
      const Cursor known = before.cursor();
      FirstContact query = of.query();
      if (query.resume(i % 2 == 0 ? corrupted(random, known) : plausible(random, known)) !=
          Status::suspended) {
        REQUIRE(query.status() == Status::suspended);  // unchanged
        ++refused;
        continue;
      }
      ++taken;
      REQUIRE(query.run(100'000'000).status != Status::suspended);
    }
  });
  CHECK(refused > 1000);
  CHECK(taken > 1000);
}

TEST_CASE("motions: any numbers are refused or lead to an end") {
  long ended = 0;
  long refused = 0;
  for_rounds(rounds(3'000L, 100'000L), 2, [&](Random& random, long) {
    const MotionScene scene = MotionScene::any(random);
    Mesh a = scene.a.baked.view();
    Mesh b = scene.b.baked.view();
    for (Mesh* const mesh : {&a, &b}) {
      for (int32_t& axis : mesh->origin) {
        axis = std::clamp(any_cells(random), -(1 << 29), 1 << 29);
      }
    }
    AnyMotion any;
    any.from = extreme_pose(random);
    any.to = extreme_pose(random);
    any.moves.resize(random.below(random.below(20) == 0 ? 70 : 4));
    for (Move& move : any.moves) {
      move = extreme_move(random, scene);
    }
    const BodyMotion motion = any.motion();
    (void)motion.pose_at(random.below(kMotionEnd));
    const auto within = static_cast<std::uint32_t>(extreme(random));
    FirstContact query(a, b, motion,
                       {random.below(2) == 0 ? 0 : within % (kMaxMotionDistance + 2)});
    if (query.status() != Status::suspended) {
      ++refused;
      return;
    }
    const FirstContactAnswer answer = query.run(100'000'000);
    REQUIRE(answer.status != Status::suspended);
    ended += answer.status == Status::done ? 1 : 0;
  });
  CHECK(ended > 300);
  CHECK(refused > 300);
}
