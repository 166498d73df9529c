// The C interface's one-call questions.
#include "flashbvh/collide.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_intersects(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, bool* yes) {
  const Answer answer = intersects(object_in(a), object_in(b), object_in(pose));
  *yes = answer.yes;
  return c_status(answer.status);
}

flashbvh_status flashbvh_first_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, bool* yes, flashbvh_pair* found) {
  PairQuery::Pair pair;
  const Answer answer = first_pair(object_in(a), object_in(b), object_in(pose), pair);
  *yes = answer.yes;
  if (answer.yes && answer.status == Status::done) {
    *found = c_pair(pair);
  }
  return c_status(answer.status);
}

flashbvh_status flashbvh_count_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                     const flashbvh_pose* pose, uint32_t* pairs) {
  const PairCount count = count_pairs(object_in(a), object_in(b), object_in(pose));
  *pairs = count.pairs;
  return c_status(count.status);
}

flashbvh_status flashbvh_find_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, flashbvh_pair* pairs,
                                    uint32_t capacity, uint32_t* count) {
  PairQuery query(object_in(a), object_in(b), object_in(pose));
  uint32_t work = UINT32_MAX;
  return c_status(run_into(query, work, pairs, capacity, *count));
}

flashbvh_status flashbvh_for_each_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                       const flashbvh_pose* pose, flashbvh_visitor* visit,
                                       void* context) {
  return c_status(for_each_pair(
      object_in(a), object_in(b), object_in(pose),
      [visit, context](const PairQuery::Pair& pair) { return visit(c_pair(pair), context); }));
}
