// The C interface to pairs of triangles.
#include "flashbvh/collide.hpp"
#include "flashbvh/contact.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(sizeof(flashbvh_cursor) == 12, "the figure in the header");

flashbvh_status flashbvh_query_start(flashbvh_query* query, const flashbvh_mesh* a,
                                     const flashbvh_mesh* b, const flashbvh_pose* pose) {
  return c_status(make(query, object_in(a), object_in(b), object_in(pose)).status());
}

flashbvh_run_result flashbvh_query_run(flashbvh_query* query, uint32_t work, flashbvh_pair* pairs,
                                       uint32_t capacity) {
  return object_in(query).run(work, pairs, capacity);
}

flashbvh_cursor flashbvh_query_cursor(const flashbvh_query* query) {
  return object_in(query).cursor();
}

flashbvh_status flashbvh_query_resume(flashbvh_query* query, const flashbvh_cursor* cursor) {
  return c_status(object_in(query).resume(*cursor));
}

void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact) {
  put(contact, [&] { return contact_of_last(object_in(query)); });
}

flashbvh_status flashbvh_intersects(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                    const flashbvh_pose* pose, bool* yes) {
  return put_answer(intersects(object_in(a), object_in(b), object_in(pose)), yes);
}

flashbvh_run_result flashbvh_find_pairs(const flashbvh_mesh* a, const flashbvh_mesh* b,
                                        const flashbvh_pose* pose, flashbvh_pair* pairs,
                                        uint32_t capacity) {
  return find_pairs(object_in(a), object_in(b), object_in(pose), pairs, capacity);
}
