// A first contact's cursor of any bytes is refused, or its query ends. Cursors of its own resume.
#include "flashbvh/first_contact.hpp"
#include "support/any_motion.hpp"
#include "support/test.hpp"

namespace {

using Cursor = FirstContact::Cursor;

/// The cursor of a query that has done some work.
Cursor any_cursor(Random& random, FirstContact query) {
  (void)query.run(1 + random.below(2000));
  return query.cursor();
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

/// Calls `test` with queries that have not run, of any bodies and motions in range.
template <class Test>
void for_queries(int count, Test test) {
  for_rounds(count, [&](Random& random, int) {
    const MotionScene scene = MotionScene::any(random);
    const AnyMotion any = any_motion(random, scene);
    const BodyMotion motion = any.motion();
    const Mesh a = scene.a.baked.view();
    const Mesh b = scene.b.baked.view();
    const FirstContact fresh(a, b, motion, {random.below(2) * 1000});
    if (fresh.status() != Status::motion_out_of_range) {
      test(random, fresh);
    }
  });
}

}  // namespace

TEST_CASE("first contacts: any numbers for a cursor are refused or lead to an end") {
  long taken = 0;
  long refused = 0;
  for_queries(rounds(100, 5'000), [&](Random& random, const FirstContact& fresh) {
    for (int i = 0; i < 100; ++i) {
      CAPTURE(i);
      const Cursor known = any_cursor(random, fresh);
      FirstContact query = fresh;
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

TEST_CASE("first contacts: cursors resume until the end, and behind `close` after pass()") {
  long closes = 0;
  for_queries(rounds(300, 5'000), [&](Random& random, const FirstContact& fresh) {
    if (fresh.status() != Status::suspended) {
      return;
    }
    FirstContact query = fresh;
    for (int i = 0; i < 1000; ++i) {
      const FirstContact::Answer answer = query.run(random.below(300));
      FirstContact other = fresh;
      REQUIRE(other.resume(query.cursor()) ==
              (answer.status == Status::suspended ? Status::suspended : Status::cursor_invalid));
      if (answer.status == Status::done) {
        if (answer.outcome != ContactOutcome::close) {
          return;
        }
        ++closes;
        query.pass();
        REQUIRE(other.resume(query.cursor()) ==
                (query.status() == Status::suspended ? Status::suspended : Status::cursor_invalid));
      }
    }
  });
  CHECK(closes > 0);
}
