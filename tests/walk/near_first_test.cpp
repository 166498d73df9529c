// A search for one pair: as ranked, and of nested surfaces. All its pairs: support/queries.hpp.
#include "flashbvh/collide.hpp"
#include "support/any_mesh.hpp"
#include "support/rotations.hpp"
#include "support/test.hpp"
#include "support/torus.hpp"

TEST_CASE("as ranked, a walk is ranked's") {
  for_rounds(200, 4, [&](Random& random, int) {
    const Scene scene = any_scene(random);
    PairQuery ranked(scene.a, scene.b, scene.pose);
    Query<detail::NearFirst<Mesh>> near(scene.a, scene.b, scene.pose,
                                        detail::NearFirst<Mesh>::as_ranked());
    REQUIRE(run_to_end(near) == run_to_end(ranked));
    REQUIRE(near.stats().visits == ranked.stats().visits);
  });
}

TEST_CASE("with 32-bit indices a query finds exactly the pairs that brute force finds") {
  for_rounds(40, 5, [&](Random& random, int) {
    const bake::LatticeMesh a = random_mesh(random, 16, 25, 25);
    const bake::LatticeMesh b = random_mesh(random, 16, 25, 25);
    const auto wide_a = bake::lay_out<std::uint32_t, Layout::post_indexed>(any_tree(random, a), a);
    const auto wide_b = bake::lay_out<std::uint32_t, Layout::post_indexed>(any_tree(random, b), b);
    const Pose pose = any_pose(random, 15);
    check_pairs(wide_a.view(), wide_b.view(), pose, brute_force(a, b, pose));
  });
}

namespace {

/// Searches two rings, one inside the other, often of few or no pairs, by first_pair().
template <class Index>
void search_nested_rings() {
  const auto ring = [](double tube) {
    const bake::LatticeMesh mesh = torus(64, 32, 9000, tube);
    return bake::lay_out<Index, Layout::post_indexed>(bake::collapse(bake::build_sah(mesh, 2), 4),
                                                      mesh);
  };
  const auto outer = ring(3000);
  const auto inner = ring(2700);
  const auto a = outer.view();
  const auto b = inner.view();
  using MeshType = std::decay_t<decltype(a)>;
  std::uint32_t found_some = 0;
  std::uint32_t none = 0;
  std::uint32_t other = 0;
  for_rounds(60, 7, [&](Random& random, std::uint32_t round) {
    const auto any = [&] { return random.between(-250, 250); };
    const Quaternion turn = {20000, any(), any(), any()};
    const std::int32_t by[3] = {any(), any(), any()};
    const Pose pose = round % 2 == 0 ? Pose::translated(by[0], by[1], by[2])
                                     : Pose::rigid(rotation_of(turn).entry, by);
    DefaultQuery<Index> query(a, b, pose);
    const Pairs pairs = run_to_end(query);
    TrianglePair<Index> found = {0xABCD, 0xDCBA};
    const Answer answer = first_pair<Index>(a, b, pose, found);
    REQUIRE(answer.status == Status::done);
    REQUIRE(answer.yes == !pairs.empty());
    none += pairs.empty() ? 1 : 0;
    if (answer.yes) {
      ++found_some;
      const Pairs::value_type first = {found.a, found.b};
      REQUIRE(std::count(pairs.begin(), pairs.end(), first) == 1);
      Query<detail::NearFirst<MeshType>> walk(a, b, pose);
      other += run_to_end(walk).front() == first ? 0 : 1;
    }
  });
  CHECK(found_some > 5);
  CHECK(none > 5);
  CHECK(other > 2);  // of the nearest pairs, not of the walk
}

}  // namespace

TEST_CASE("a search finds a pair of nested surfaces if there is one, wherever it lies") {
  search_nested_rings<std::uint16_t>();
  search_nested_rings<std::uint32_t>();
}

// Also if its walk is within that pair's leaves when it looks elsewhere.
TEST_CASE("a search finds the only pair of nested surfaces, whichever triangle it has") {
  const auto ring = [](double tube) { return torus(16, 8, 9000, tube); };
  const auto baked = [](const bake::LatticeMesh& mesh) {
    return bake::lay_out<std::uint16_t, Layout::post_indexed>(
        bake::collapse(bake::build_sah(mesh, 2), 4), mesh);
  };
  const auto outer = baked(ring(3000));
  const bake::LatticeMesh inner = ring(2700);
  const bake::LatticeMesh beyond = ring(3400);
  bake::LatticeMesh spiked = inner;  // whose triangles share no corners
  spiked.vertices.clear();
  for (bake::TriangleCorners& triangle : spiked.triangles) {
    for (std::uint32_t& corner : triangle) {
      spiked.vertices.push_back(inner.vertices[corner]);
      corner = static_cast<std::uint32_t>(spiked.vertices.size() - 1);
    }
  }
  for_rounds(rounds(4, 60), 8, [&](Random& random, int) {
    const auto any = [&] { return random.between(-100, 100); };
    const std::int32_t by[3] = {any(), any(), any()};
    const Quaternion turn = {20000, any(), any(), any()};
    const Pose pose = Pose::rigid(rotation_of(turn).entry, by);
    for (std::size_t at = 0; at < inner.triangles.size(); ++at) {
      const std::uint32_t corner = inner.triangles[at][0];
      spiked.vertices[3 * at] = beyond.vertices[corner];
      const auto with_spike = baked(spiked);
      spiked.vertices[3 * at] = inner.vertices[corner];
      TrianglePair<std::uint16_t> found;
      CAPTURE(at);
      REQUIRE(first_pair<std::uint16_t>(outer.view(), with_spike.view(), pose, found).yes);
      REQUIRE(found.b == at);
    }
  });
}
