// A deformable sheet of 1,012 triangles: the costs of a refit, and of queries against itself, flat
// and crumpled.
#include "costs.hpp"
#include "flashbvh/deformable.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/self.hpp"
#include "sheet.fbvh.h"
#include "support/random.hpp"

using namespace flashbvh;

namespace figures {
namespace {

const Mesh sheet = view_unchecked<Mesh>(sheet_image);

// Static, since the smallest board's stack is too small.
Node<uint16_t> nodes[sheet_NODE_COUNT];
Vertex vertices[sheet_VERTEX_COUNT];

void crumple() {
  test::Random random(3);
  for (uint32_t i = 0; i < sheet_VERTEX_COUNT; ++i) {
    const Vertex& flat = sheet.vertices[i];
    const auto near = [&random](int32_t at) {
      return static_cast<int16_t>(at + random.between(-300, 300));
    };
    vertices[i] = {near(flat.x * 3 / 5), near(flat.y * 3 / 5), near(flat.x / 600 % 2 * 300)};
  }
}

template <class QueryType>
bool measure_query(const char* what, const char* how, QueryType query) {
  Status status{};
  measure({{"bending", what, how}}, [&] {
    status = query.run(UINT32_MAX, [](const typename QueryType::Pair&) { return true; }).status;
  });
  add_count({{"bending", "pairs", what, how}}, query.stats().triangle_pairs);
  add_to_digest(query.stats());
  return status == Status::done;
}

bool measure_all(DeformableMesh& bent, const char* how) {
  Status status{};
  measure({{"bending", "refit", how}}, [&] { status = bent.refit().status; });
  const bool itself = measure_query("itself", how, SelfQuery(bent.mesh()));
  return measure_query("band", how, SelfWithinQuery(bent.mesh(), within({20 * 256}))) && itself &&
         status == Status::done;
}

}  // namespace

bool measure_bending() {
  DeformableMesh bent(sheet, nodes, vertices);
  const bool flat = measure_all(bent, "flat");
  crumple();
  return measure_all(bent, "crumpled") && flat;
}

}  // namespace figures
