// The C interface to contacts.
#include "flashbvh/contact.hpp"
#include "flashbvh/units.hpp"
#include "objects.hpp"

using namespace flashbvh;

void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b) {
  object_in(query).last_pair(*a, *b);
}

void flashbvh_contact_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                         flashbvh_contact* contact) {
  put(contact, [&] { return contact_of(*a, *b); });
}

void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact) {
  put(contact, [&] { return contact_of_last(object_in(query)); });
}

bool flashbvh_transform_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                             const flashbvh_pose* pose, flashbvh_pair pair, flashbvh_triangle* of_a,
                             flashbvh_triangle* of_b) {
  return transform_pair(object_in(a), object_in(b), object_in(pose), pair, *of_a, *of_b);
}

void flashbvh_in_millionths(const flashbvh_fine_point* point, const flashbvh_mesh* mesh,
                            int64_t at[3]) {
  const uint64_t cell_bits = object_in(mesh).cell_bits;
  at[0] = millionths_of(point->x, cell_bits);
  at[1] = millionths_of(point->y, cell_bits);
  at[2] = millionths_of(point->z, cell_bits);
}
