// A C query against its C++ counterpart, cut into random runs, saved, copied and resumed.
#pragma once

#include "c_api/scene.hpp"
#include "flashbvh/deformable.h"
#include "flashbvh/deformable.hpp"

namespace flashbvh::test {

/// The traversal part of a cursor in either language.
template <class Walk>
Walk& walk_of(Walk& position) {
  return position;
}
inline flashbvh_cursor& walk_of(flashbvh_self_cursor& position) {
  return position.at;
}
template <class Index>
QueryCursor<Index>& walk_of(DeformableCursor<Index>& position) {
  return position.at;
}

/// The common part of queries that return pairs. `C` names the functions:
///     Struct, Position       the C types
///     query(scene)           the C++ query
///     start, run, counts, position, resume
///     kVisits                whether visit, status and last_pair exist, too
template <class C>
class Slices {
 public:
  explicit Slices(Scene& scene) : scene_(scene), query_(C::query(scene)) {}

  bool agree() {
    bool agrees = same(C::start(&c_, scene_), query_.status());
    bool goes_on = true;
    while (agrees && goes_on) {
      RunResult step = {};
      agrees = run(step) && same(C::counts(&c_), C::counts_of(query_));
      goes_on = step.status == Status::suspended || step.status == Status::full;
      if constexpr (C::kVisits) {
        agrees = agrees && same(C::status(&c_), query_.status()) && last_pair(step);
      }
      agrees = agrees && (!goes_on || move());
    }
    return agrees;
  }

 private:
  bool run(RunResult& step) {
    const std::uint32_t capacity = scene_.random.below(kMostKept + 1);
    if constexpr (C::kVisits) {
      if (capacity != 0 && scene_.random.below(3) == 0) {
        return visit(step, capacity);
      }
    }
    const std::uint32_t work = scene_.any_work();
    flashbvh_pair wanted[kMostKept];
    flashbvh_pair found[kMostKept];
    step = query_.run(work, wanted, capacity);
    return same(C::run(&c_, work, found, capacity), step) && same(found, wanted, step.count);
  }

  bool visit(RunResult& step, std::uint32_t capacity) {
    Kept wanted = {capacity, 0, {}};
    Kept found = wanted;
    const std::uint32_t work = scene_.any_work();
    step = query_.run(work, [&](const flashbvh_pair& p) { return keep(p, &wanted); });
    return same(C::visit(&c_, work, keep, &found), step) && same(found, wanted);
  }

  bool last_pair(const RunResult& step) {
    Triangle wanted[2];
    flashbvh_triangle found[2];
    if (step.status != Status::full || step.count == 0) {
      return true;
    }
    query_.last_pair(wanted[0], wanted[1]);
    C::last_pair(&c_, &found[0], &found[1]);
    return same(wanted, found, 2);
  }

  /// Moves to another address, or by cursor to another query, in both languages.
  bool move() {
    if (scene_.random.below(2) == 0) {
      const typename C::Struct copy = c_;
      wipe(c_);
      c_ = copy;
      return true;
    }
    if (!refusals_agree()) {
      return false;
    }
    const auto position = C::position(&c_);
    auto again = C::query(scene_);
    (void)again.resume(query_.cursor());
    query_ = again;
    wipe(c_);
    (void)C::start(&c_, scene_);
    return same(C::resume(&c_, &position), query_.status());
  }

  /// Tests cursors that may be invalid.
  bool refusals_agree() {
    auto copy = query_;
    typename C::Struct c_copy = c_;
    auto wrong = query_.cursor();
    auto c_wrong = C::position(&c_);
    walk_of(c_wrong).untested ^= static_cast<std::uint16_t>(scene_.random.below(2));
    walk_of(c_wrong).a += static_cast<std::uint16_t>(scene_.random.below(3));
    walk_of(wrong).untested = walk_of(c_wrong).untested;
    walk_of(wrong).a = walk_of(c_wrong).a;
    return same(C::resume(&c_copy, &c_wrong), copy.resume(wrong));
  }

  Scene& scene_;
  decltype(C::query(*static_cast<Scene*>(nullptr))) query_;
  typename C::Struct c_;
};

}  // namespace flashbvh::test
