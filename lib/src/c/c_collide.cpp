// The C interface to one-call queries.
#include "flashbvh/collide.hpp"
#include "objects.hpp"

using namespace flashbvh;

flashbvh_status flashbvh_intersects(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, bool* yes) {
  return put_answer(intersects(object_in(a), object_in(b), object_in(pose)), yes);
}

flashbvh_status flashbvh_intersects_hinted(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                           const flashbvh_pose* pose, flashbvh_witness* hint,
                                           bool* yes) {
  Witness<uint16_t> witness = {hint->a, hint->b};
  const Answer answer = intersects(object_in(a), object_in(b), object_in(pose), witness);
  *hint = {witness.a, witness.b};
  return put_answer(answer, yes);
}

flashbvh_status flashbvh_first_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, bool* yes, flashbvh_pair* found) {
  return put_answer(first_pair(object_in(a), object_in(b), object_in(pose), *found), yes);
}

flashbvh_run_result flashbvh_count_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                         const flashbvh_pose* pose) {
  return count_pairs(object_in(a), object_in(b), object_in(pose));
}

flashbvh_run_result flashbvh_find_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                        const flashbvh_pose* pose, flashbvh_pair* pairs,
                                        uint32_t capacity) {
  return find_pairs(object_in(a), object_in(b), object_in(pose), pairs, capacity);
}

flashbvh_status flashbvh_for_each_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                       const flashbvh_pose* pose, flashbvh_visitor* visit,
                                       void* context) {
  return c_status(
      for_each_pair(object_in(a), object_in(b), object_in(pose),
                    [visit, context](const flashbvh_pair& pair) { return visit(pair, context); }));
}
