// Which tree stays good under bending, and whether ranks are worth making again: visits of self
// queries and of a bent mesh against another one, of trees made of the mesh at rest.
#include <cmath>
#include <cstdio>
#include <utility>

#include "flashbvh/self.hpp"
#include "support/bending.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

/// Two sheets, one cell above the other: what a tree of the mesh at rest is made worst for.
bake::LatticeMesh bag(Random& random) {
  bake::LatticeMesh mesh = grid(20, 12, false);
  lay(random, 21, 300, 0, 0, mesh.vertices.data(), mesh.vertices.size());
  const auto count = static_cast<std::uint32_t>(mesh.vertices.size());
  for (std::uint32_t v = 0; v < count; ++v) {
    Vertex up = mesh.vertices[v];
    up.z = 1;
    mesh.vertices.push_back(up);
  }
  const std::size_t triangles = mesh.triangles.size();
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& of = mesh.triangles[t];
    mesh.triangles.push_back({of[0] + count, of[2] + count, of[1] + count});
  }
  return mesh;
}

/// Rolled, blown up, folded or crumpled.
void bend(Random& random, int way, const std::vector<Vertex>& rest, std::vector<Vertex>& to) {
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const double x = rest[i].x;
    const double y = rest[i].y;
    const double side = i < rest.size() / 2 ? 1 : -1;
    const double turn = x / 1500;
    const double radius = 700 + 0.15 * x;
    const double at[4][3] = {
        {radius * std::cos(turn), y, radius * std::sin(turn)},
        {x, y, side * 1500 * std::sin(x / 2000) * std::sin(y / 1300)},
        {x / 2, y, 500 * std::sin(x / 300)},
        {0.4 * x + random.between(-300, 300), 0.4 * y + random.between(-300, 300),
         800 * std::sin(x / 400) * std::cos(y / 400)}};
    to[i] = {static_cast<std::int16_t>(at[way][0]), static_cast<std::int16_t>(at[way][1]),
             static_cast<std::int16_t>(at[way][2])};
  }
}

template <class Query>
std::uint32_t visits_of(Query&& query) {
  (void)query.run(UINT32_MAX, [](const TrianglePair<std::uint16_t>&) { return true; });
  return query.stats().visits;
}

/// Of the same tree with ranks of the boxes that it has now.
bake::BakedTree<std::uint16_t, Layout::post_indexed> ranked_anew(bake::BuildTree tree,
                                                                 const bake::LatticeMesh& now) {
  for (std::size_t node = tree.nodes.size(); node-- != 0;) {
    std::vector<std::uint32_t> below = tree.nodes[node].triangles;
    std::vector<std::uint32_t> pending = tree.nodes[node].children;
    while (!pending.empty()) {
      const bake::BuildNode& at = tree.nodes[pending.back()];
      pending.pop_back();
      below.insert(below.end(), at.triangles.begin(), at.triangles.end());
      pending.insert(pending.end(), at.children.begin(), at.children.end());
    }
    Box& box = tree.nodes[node].box;
    box.lower = box.upper = now.vertices[now.triangles[below[0]][0]];
    for (const std::uint32_t triangle : below) {
      for (const std::uint32_t corner : now.triangles[triangle]) {
        const Vertex& v = now.vertices[corner];
        box.lower = {std::min(box.lower.x, v.x), std::min(box.lower.y, v.y),
                     std::min(box.lower.z, v.z)};
        box.upper = {std::max(box.upper.x, v.x), std::max(box.upper.y, v.y),
                     std::max(box.upper.z, v.z)};
      }
    }
  }
  return bake::lay_out<std::uint16_t, Layout::post_indexed>(tree, now);
}

void tell(const char* name, const bake::LatticeMesh& rest, const bake::BuildTree& tree) {
  Bending<Mesh> bent(tree, rest);
  Bending<Mesh> other(tree, rest);
  std::printf("%-22s %6zu", name, bent.nodes.size());
  std::uint32_t anew = 0;
  std::uint32_t kept = 0;
  for (int way = 0; way < 4; ++way) {
    Random random(way + 1u);
    bend(random, way, rest.vertices, bent.vertices);
    (void)bent.mesh.refit();
    const Pose pose = Pose::translated(300, 200, 150);
    const std::uint32_t self = visits_of(SelfQuery(bent.mesh.mesh()));
    const std::uint32_t pair = visits_of(PairQuery(bent.mesh.mesh(), other.mesh.mesh(), pose));
    const auto reranked = ranked_anew(tree, bent.now());
    const Mesh view = reranked.view();
    kept += self + pair;
    anew += visits_of(SelfQuery(view)) + visits_of(PairQuery(view, other.mesh.mesh(), pose));
    std::printf(" %8u %8u", static_cast<unsigned>(self), static_cast<unsigned>(pair));
  }
  std::printf("   %.3f\n", static_cast<double>(anew) / kept);
}

}  // namespace

int main() {
  Random random(1);
  bake::LatticeMesh sheet = grid(20, 24, false);
  lay(random, 21, 300, 0, 0, sheet.vertices.data(), sheet.vertices.size());
  const bake::LatticeMesh two = bag(random);
  std::printf("%-22s %6s %17s %17s %17s %17s  new ranks\n", "visits: itself, other", "nodes",
              "rolled", "blown up", "folded", "crumpled");
  for (const bake::LatticeMesh* const mesh : {&std::as_const(sheet), &two}) {
    std::printf(mesh == &sheet ? "sheet\n" : "bag\n");
    for (const std::uint32_t leaf_size : {1u, 2u, 3u, 4u}) {
      for (const std::uint32_t arity : {2u, 4u}) {
        char name[40];
        std::snprintf(name, sizeof name, "sah, leaf %u, arity %u", static_cast<unsigned>(leaf_size),
                      static_cast<unsigned>(arity));
        tell(name, *mesh, bake::collapse(bake::build_sah(*mesh, leaf_size), arity));
      }
    }
    tell("median", *mesh, bake::build_median(*mesh, 1));
  }
}
