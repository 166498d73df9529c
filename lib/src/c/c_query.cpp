// The C interface to queries.
#include "objects.hpp"

using namespace flashbvh;

static_assert(sizeof(flashbvh_cursor) == 12, "the figure in the header");

flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose) {
  return c_status(make(query, object_in(a), object_in(b), object_in(pose)).status());
}

flashbvh_status flashbvh_query_status(const flashbvh_query* query) {
  return c_status(object_in(query).status());
}

flashbvh_run_result flashbvh_query_run(flashbvh_query* query, uint32_t work, flashbvh_pair* pairs,
                                       uint32_t capacity) {
  return object_in(query).run(work, pairs, capacity);
}

flashbvh_run_result flashbvh_query_visit(flashbvh_query* query, uint32_t work,
                                         flashbvh_visitor* visit, void* context) {
  return object_in(query).run(
      work, [visit, context](const flashbvh_pair& pair) { return visit(pair, context); });
}

flashbvh_stats flashbvh_query_stats(const flashbvh_query* query) {
  return object_in(query).stats();
}

flashbvh_cursor flashbvh_query_cursor(const flashbvh_query* query) {
  return object_in(query).cursor();
}

flashbvh_status flashbvh_query_resume(flashbvh_query* query, const flashbvh_cursor* cursor) {
  return c_status(object_in(query).resume(*cursor));
}
