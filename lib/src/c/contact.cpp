// The C interface to contacts.
#include "flashbvh/contact.hpp"
#include "flashbvh/length.hpp"
#include "objects.hpp"

using namespace flashbvh;

static_assert(FLASHBVH_CONTACT_DEGENERATE == static_cast<int>(ContactKind::degenerate),
              "one list of kinds");

namespace {

flashbvh_fine_point c_point(const FinePoint& p) {
  return {p.x, p.y, p.z};
}
flashbvh_normal c_normal(const Normal& n) {
  return {n.x, n.y, n.z};
}

void put(const Contact& found, flashbvh_contact* contact) {
  contact->ends[0] = c_point(found.ends[0]);
  contact->ends[1] = c_point(found.ends[1]);
  contact->normal_a = c_normal(found.normal_a);
  contact->normal_b = c_normal(found.normal_b);
  contact->kind = static_cast<flashbvh_contact_kind>(found.kind);
}

}  // namespace

void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b) {
  Triangle placed_a;
  Triangle placed_b;
  object_in(query).last_pair(placed_a, placed_b);
  put(placed_a, a);
  put(placed_b, b);
}

void flashbvh_contact_of(const flashbvh_triangle* a, const flashbvh_triangle* b,
                         flashbvh_contact* contact) {
  put(contact_of(triangle_of(*a), triangle_of(*b)), contact);
}

void flashbvh_query_last_contact(const flashbvh_query* query, flashbvh_contact* contact) {
  put(contact_of_last(object_in(query)), contact);
}

bool flashbvh_transform_pair(const flashbvh_mesh* a, const flashbvh_mesh* b,
                             const flashbvh_pose* pose, flashbvh_pair pair, flashbvh_triangle* of_a,
                             flashbvh_triangle* of_b) {
  Triangle placed_a;
  Triangle placed_b;
  if (!transform_pair(object_in(a), object_in(b), object_in(pose), {pair.a, pair.b}, placed_a,
                      placed_b)) {
    return false;
  }
  put(placed_a, of_a);
  put(placed_b, of_b);
  return true;
}

void flashbvh_in_millionths(const flashbvh_fine_point* point, const flashbvh_mesh* mesh,
                            int64_t at[3]) {
  const uint64_t cell_bits = object_in(mesh).cell_bits;
  at[0] = millionths_of(point->x, cell_bits);
  at[1] = millionths_of(point->y, cell_bits);
  at[2] = millionths_of(point->z, cell_bits);
}
