// The C interface to queries.
#include "objects.hpp"

using namespace flashbvh;

namespace {

using Position = QueryPosition<uint16_t>;

static_assert(sizeof(flashbvh_position) == 12, "the figure in the header");

flashbvh_triangle c_triangle(const Triangle& transformed) {
  flashbvh_triangle triangle;
  for (int i = 0; i < 3; ++i) {
    const Point& corner = transformed.corner[i];
    triangle.corner[i] = {corner.x, corner.y, corner.z};
  }
  return triangle;
}

}  // namespace

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

flashbvh_counts flashbvh_query_counts(const flashbvh_query* query) {
  const Counts& counts = object_in(query).counts();
  return {counts.visits, counts.overlaps, counts.leaf_pairs, counts.triangle_pairs};
}

void flashbvh_query_last_pair(const flashbvh_query* query, flashbvh_triangle* a,
                              flashbvh_triangle* b) {
  Triangle transformed_a;
  Triangle transformed_b;
  object_in(query).last_pair(transformed_a, transformed_b);
  *a = c_triangle(transformed_a);
  *b = c_triangle(transformed_b);
}

flashbvh_position flashbvh_query_position(const flashbvh_query* query) {
  const Position position = object_in(query).position();
  return {
      position.a, position.b, position.untested, static_cast<uint8_t>(position.state), {0, 0, 0}};
}

flashbvh_status flashbvh_query_resume(flashbvh_query* query, const flashbvh_position* position) {
  Position to;
  to.a = position->a;
  to.b = position->b;
  to.untested = position->untested;
  to.state = static_cast<Position::State>(position->state);
  return c_status(object_in(query).resume(to));
}
