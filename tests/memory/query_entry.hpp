// The entry of a query object, whatever its traversal: what firmware calls tick by tick.
#ifndef FLASHBVH_TESTS_MEMORY_QUERY_ENTRY_HPP
#define FLASHBVH_TESTS_MEMORY_QUERY_ENTRY_HPP

#include "memory/arguments.hpp"

namespace memory {

/// The array of pairs that traversals with a stack have.
template <class Asked>
Asked made_query(Arguments& in, const typename Asked::Mesh& a, const typename Asked::Mesh& b) {
  if constexpr (__is_constructible(typename Asked::Cursor)) {
    return Asked(a, b, *in.pose);
  } else {
    return Asked(a, b, *in.pose, typename Asked::Cursor(in.stack, kStackEntries));
  }
}

/// Not inlined: its frame is gone when a slice runs.
template <class Asked>
[[gnu::noinline]] void make_query(Arguments& in, const typename Asked::Mesh& a,
                                  const typename Asked::Mesh& b) {
  make_in<Asked>(in.query, [&] { return made_query<Asked>(in, a, b); });
}

/// Makes the query if no visits are granted, else runs it for a slice.
template <class Asked>
inline void make_or_run(Arguments& in, const typename Asked::Mesh& a,
                        const typename Asked::Mesh& b) {
  if (in.visits == 0) {
    make_query<Asked>(in, a, b);
    return;
  }
  const flashbvh::Step step =
      reinterpret_cast<Asked*>(in.query.bytes)->run(in.visits, in.found, in.capacity);
  in.answer += step.count;
  in.status = static_cast<uint8_t>(step.status);
}

}  // namespace memory

#endif
