// The C interface to queries.
#include "objects.hpp"

using namespace flashbvh;

static_assert(sizeof(flashbvh_position) == 12, "the figure in the header");

flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose) {
  new (storage_of<PairQuery>(query)) PairQuery(object_in(a), object_in(b), object_in(pose));
  return c_status(object_in(query).status());
}

flashbvh_status flashbvh_query_status(const flashbvh_query* query) {
  return c_status(object_in(query).status());
}

flashbvh_status flashbvh_query_run(flashbvh_query* query, uint32_t work, flashbvh_pair* pairs,
                                   uint32_t capacity, uint32_t* count) {
  return c_status(run_into(object_in(query), work, pairs, capacity, *count));
}

flashbvh_status flashbvh_query_spend(flashbvh_query* query, uint32_t* work, flashbvh_pair* pairs,
                                     uint32_t capacity, uint32_t* count) {
  return c_status(run_into(object_in(query), *work, pairs, capacity, *count));
}

flashbvh_status flashbvh_query_visit(flashbvh_query* query, uint32_t* work, flashbvh_visitor* visit,
                                     void* context) {
  return c_status(object_in(query).spend(*work, [visit, context](const PairQuery::Pair& pair) {
    return visit(c_pair(pair), context);
  }));
}

flashbvh_counts flashbvh_query_counts(const flashbvh_query* query) {
  return c_counts(object_in(query).counts());
}

flashbvh_position flashbvh_query_position(const flashbvh_query* query) {
  return c_position(object_in(query).position());
}

flashbvh_status flashbvh_query_resume(flashbvh_query* query, const flashbvh_position* position) {
  QueryPosition<uint16_t> to;
  to.a = position->a;
  to.b = position->b;
  to.untested = position->untested;
  to.state = static_cast<QueryPosition<uint16_t>::State>(position->state);
  return c_status(object_in(query).resume(to));
}
