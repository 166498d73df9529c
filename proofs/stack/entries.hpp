// The includes of entries.inc, and a function for the entry whose source has
// `#define CHOSEN_NAME ~, extern "C" void`. Each entry is compiled alone, like in firmware.
#include "proofs/stack/arguments.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using stack_proof::Arguments;
using stack_proof::as;
using stack_proof::floats_as;
using stack_proof::make_in;

namespace entries {

/// Not inlined, so that its frame is gone when a slice runs.
template <class QueryType>
[[gnu::noinline]] void make_query(Arguments& in, const typename QueryType::Mesh& a,
                                  const typename QueryType::Mesh& b) {
  make_in<QueryType>(in.query, [&] {
    if constexpr (__is_constructible(typename QueryType::Cursor)) {
      return QueryType(a, b, *in.pose);
    } else {  // the array of pairs of traversals with a stack
      return QueryType(a, b, *in.pose,
                       typename QueryType::Cursor(in.stack, stack_proof::kStackEntries));
    }
  });
}

/// Makes the query if the work budget is 0, else runs it for a slice.
template <class QueryType>
[[gnu::always_inline]] inline void make_or_run(Arguments& in, const typename QueryType::Mesh& a,
                                               const typename QueryType::Mesh& b) {
  if (in.work == 0) {
    make_query<QueryType>(in, a, b);
    return;
  }
  const RunResult step = as<QueryType>(in.query).run(in.work, in.found, in.capacity);
  in.answer += step.count;
  in.status = static_cast<uint8_t>(step.status);
}

[[gnu::always_inline]] inline void make_or_run_c(Arguments& in) {
  auto* const query = &as<flashbvh_query>(in.query);
  if (in.work == 0) {
    in.ends(flashbvh_query_start(query, in.c_a, in.c_b, in.c_pose));
    return;
  }
  new (InPlace{&in.step}) RunResult(flashbvh_query_run(query, in.work, in.c_found(), in.capacity));
  in.ends(in.step.status);
  in.answer += in.step.count;
}

/// A call in C that returns yes or no.
template <class Call>
[[gnu::always_inline]] inline void decide(Arguments& in, const Call& call) {
  bool yes = false;
  in.ends(call(&yes));
  in.answer = yes ? 1 : 0;
}

/// No hint, and some hints far from the nearest pair, which the walk then finds.
constexpr uint16_t kSeeds = 5;
template <class W>
W seed_of(uint16_t i) {
  const auto at = static_cast<uint16_t>(3 * i - 3);
  return i == 0 ? W() : W{at, at};
}

/// All pairs of the first triangles.
constexpr uint16_t kMostPairs = 100;
template <class W>
W pair_of(uint16_t i) {
  return {static_cast<uint16_t>(i / 10), static_cast<uint16_t>(i % 10)};
}

[[gnu::noinline]] inline void make_clearance(Arguments& in, const Witness<uint16_t>& seed) {
  make_in<ClearanceQuery>(in.query, [&] { return ClearanceQuery(*in.a, *in.b, *in.pose, seed); });
}
[[gnu::noinline]] inline void make_within(Arguments& in) {
  make_in<WithinQuery>(
      in.query, [&] { return WithinQuery(*in.a, *in.b, *in.pose, {}, within({in.distance})); });
}
[[gnu::noinline]] inline void start_clearance(Arguments& in, const flashbvh_witness* seed) {
  in.ends(flashbvh_clearance_start(&as<flashbvh_clearance_query>(in.query), in.c_a, in.c_b,
                                   in.c_pose, seed));
}

/// Queries a deformable mesh against itself.
template <class QueryType, class... Predicate>
[[gnu::always_inline]] inline void query_itself(Arguments& in, const Predicate&... question) {
  const auto make = [&]() __attribute__((noinline)) {
    make_in<QueryType>(in.query, [&] { return QueryType(*in.bent, question...); });
  };
  make();
  in.counts(as<QueryType>(in.query));
}

[[gnu::always_inline]] inline Guard& updated_guard(Arguments& in) {
  constexpr JointCoordinate values[1] = {0};
  auto& guard = make_in<Guard>(in.query, [&] { return Guard(*in.robot, *in.guard_state); });
  in.ends(guard.update(values, UINT32_MAX).status);
  return guard;
}

[[gnu::always_inline]] inline void add_to_workcell(Arguments& in) {
  Workcell cell(*in.robot, *in.workcell_memory);
  uint8_t tool = 0;
  uint8_t obstacle = 0;
  in.ends(cell.add(*in.a, {0, kIdentityFrame}, tool));
  in.ends(cell.add(*in.a, {kBase, kIdentityFrame}, obstacle));
  in.ends(cell.keep_apart(tool, obstacle, {0}, {0}));
  in.ends(cell.move(obstacle, kIdentityFrame, {1}));
}

constexpr int32_t kPoints = 162;
template <class P>
P any_point(int32_t i) {
  return {4000 * (i % 9) - 16000, 4000 * (i / 9 % 9) - 16000, i < 81 ? 0 : -500};
}

/// Segments from nine points along nine directions, and in the planes of triangles.
inline Segment any_segment(const Mesh& mesh, uint32_t i) {
  if (i < 81) {
    const auto at = static_cast<int32_t>(i);
    return {{4000 * (at % 9) - 16000, 20000, 0}, {4000 * (at / 9) - 16000, -20000, 300}};
  }
  const auto& corner = mesh.triangles[i % mesh.triangle_count].corner;
  const Vertex& u = mesh.vertices[corner[i % 3]];
  const Vertex& v = mesh.vertices[corner[(i + 1) % 3]];
  const Vertex& w = mesh.vertices[corner[(i + 2) % 3]];
  const int32_t* const o = mesh.origin;
  return {{o[0] + 2 * u.x - v.x, o[1] + 2 * u.y - v.y, o[2] + 2 * u.z - v.z},
          {o[0] + 2 * w.x - u.x, o[1] + 2 * w.y - u.y, o[2] + 2 * w.z - u.z}};
}

inline flashbvh_segment any_c_segment(const Mesh& mesh, uint32_t i) {
  const Segment segment = any_segment(mesh, i);
  return {{segment.from.x, segment.from.y, segment.from.z},
          {segment.to.x, segment.to.y, segment.to.z}};
}

// Other entries are templates without an instance.
#define SECOND(first, second, ...) second
#define LINKAGE(...) SECOND(__VA_ARGS__, template <class Arguments> void, ~)
#define ENTRY(name, kind, most, ...)           \
  LINKAGE(CHOSEN_##name) name(Arguments* in) { \
    __VA_ARGS__;                               \
  }
#include "proofs/stack/entries.inc"
#undef ENTRY

}  // namespace entries
