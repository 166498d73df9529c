// A sheet of 1,012 triangles that bends: what a refit takes, and questions about itself, flat and
// crumpled.
#include "flashbvh/deformable.hpp"
#include "flashbvh/self.hpp"
#include "insn.hpp"
#include "report.hpp"
#include "sheet.fbvh.hpp"
#include "support/random.hpp"

using namespace flashbvh;

namespace figures {
namespace {

// Static, since the smallest board has no such stack.
Node<uint16_t> nodes[sheet::kNodeCount];
Vertex vertices[sheet::kVertexCount];

void crumple() {
  test::Random random(3);
  for (uint32_t i = 0; i < sheet::kVertexCount; ++i) {
    const Vertex& flat = sheet::mesh.vertices[i];
    const auto near = [&random](int32_t at) {
      return static_cast<int16_t>(at + random.between(-300, 300));
    };
    vertices[i] = {near(flat.x * 3 / 5), near(flat.y * 3 / 5), near(flat.x / 600 % 2 * 300)};
  }
}

template <class Asked>
void ask(const char* what, const char* how, Asked query) {
  Status status{};
  const uint32_t instructions = port::instructions_of([&] {
    status = query.run(UINT32_MAX, [](const typename Asked::Pair&) { return true; }).status;
  });
  print_figure({{"bending", what, how}}, status == Status::done ? instructions : UINT32_MAX);
  print_count({{"bending", "pairs", what, how}}, query.counts().triangle_pairs);
  counted.add(query.counts());
}

bool ask_all(DeformableMesh& bent, const char* how) {
  Status status{};
  const uint32_t instructions = port::instructions_of([&] { status = bent.refit().status; });
  print_figure({{"bending", "refit", how}}, instructions);
  ask("itself", how, SelfQuery(bent.mesh()));
  ask("band", how, SelfWithinQuery(bent.mesh(), within(20 * 256)));
  return status == Status::done;
}

}  // namespace
}  // namespace figures

int main() {
  figures::print_core();
  DeformableMesh bent(sheet::mesh, figures::nodes, figures::vertices);
  const bool flat = figures::ask_all(bent, "flat");
  figures::crumple();
  const bool crumpled = figures::ask_all(bent, "crumpled");
  figures::print_count({{"bending", "digest"}}, figures::counted.value());
  return flat && crumpled ? 0 : 1;
}
