// Coarser meshes: within their limit both ways, complete, with few triangles, reproducible.
#include "simplify/coarsening.hpp"

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "simplify/zoo.hpp"

using namespace flashbvh::test;
using simplify::Coarsening;

namespace {

double most_sampled(const bake::SourceMesh& of, const bake::SourceMesh& to, Random& random) {
  double most = 0;
  const int samples = is_thorough() ? 1'000'000 : 150;
  for (int i = 0; i < samples; ++i) {
    most = std::max(most, distance_by_force(any_point_of(random, of), to));
  }
  return most;
}

bool is_on_lattice(const bake::SourceMesh& mesh, double cell) {
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& vertex) {
    return std::all_of(vertex.begin(), vertex.end(), [&](double coordinate) {
      return std::round(coordinate / cell) * cell == coordinate;
    });
  });
}

/// A flat, open grid of `squares` x `squares`, in steps of 10, with one inner vertex 1 up.
bake::SourceMesh bumpy(std::uint32_t squares) {
  bake::SourceMesh mesh = grid(squares, squares, false, [&](double u, double v) -> simplify::Point {
    return {std::round(10 * squares * u), std::round(10 * squares * v), 0};
  });
  mesh.vertices[squares / 2 * (squares + 1) + squares / 2][2] = 1;
  return mesh;
}

}  // namespace

TEST_CASE("neither mesh is farther from the other than certified, and that is within the limit") {
  Random random(test_seed());
  for (const Specimen& specimen : specimens()) {
    const double cell = finest_cell_of(specimen.mesh);
    Coarsening coarsening(specimen.mesh, cell);
    std::size_t before = specimen.mesh.triangles.size();
    for (const double limit : {0.01, 0.1, 0.5, 2.0}) {
      CAPTURE(specimen.name, limit);
      coarsening.coarsen(limit);
      const bake::SourceMesh coarse = coarsening.mesh();
      const simplify::Deviation certified = coarsening.deviation();
      const double deviation = certified.most;
      REQUIRE_FALSE(coarse.triangles.empty());
      CHECK(deviation <= limit);
      CHECK(deviation <= 1.1 * certified.at_least + 1e-3 * cell);
      CHECK(most_sampled(specimen.mesh, coarse, random) <= deviation);
      CHECK(most_sampled(coarse, specimen.mesh, random) <= deviation);
      CHECK(coarse.triangles.size() <= before);
      CHECK(is_on_lattice(coarse, cell));
      if (specimen.is_closed) {
        CHECK(bake::is_closed(coarse.triangles));
      }
      before = coarse.triangles.size();
    }
  }
}

TEST_CASE("a mesh that can deviate by exactly the limit is certified") {
  for (const std::uint32_t squares : {2U, 4U, 8U, 40U}) {
    for (const double cell : {1.0 / 8, 1.0 / 64, 1.0 / 128}) {
      for (const double limit : {0.5, 1.0, std::nextafter(1, 2)}) {
        CAPTURE(squares, cell, limit);
        Coarsening coarsening(bumpy(squares), cell);
        coarsening.coarsen(limit);
        CHECK(coarsening.deviation().most <= limit);
      }
    }
  }
}

TEST_CASE("the least limit is certified") {
  for (const Specimen& specimen : specimens()) {
    for (const double parts : {1.0, 8.0, 1000.0}) {
      CAPTURE(specimen.name, parts);
      Coarsening coarsening(specimen.mesh, parts * finest_cell_of(specimen.mesh));
      coarsening.coarsen(coarsening.rounding());
      CHECK(coarsening.deviation().most <= coarsening.rounding());
    }
  }
}

TEST_CASE("what is flat needs few triangles") {
  const bake::SourceMesh mesh = box({0, 0, 0}, {80, 50, 20}, 16);
  Coarsening coarsening(mesh, finest_cell_of(mesh));
  coarsening.coarsen(0.1);
  CHECK(coarsening.mesh().triangles.size() == 12);
}

TEST_CASE("a shell stays, however small") {
  const bake::SourceMesh mesh = many_shells();
  Coarsening coarsening(mesh, finest_cell_of(mesh));
  coarsening.coarsen(2);
  const bake::SourceMesh coarse = coarsening.mesh();
  for (const auto& vertex : mesh.vertices) {
    REQUIRE(distance_by_force(vertex, coarse) <= 2);
  }
  CHECK(coarse.triangles.size() < 80);
}

TEST_CASE("shells that rounding makes a point, an edge or a sheet are simplified") {
  bake::SourceMesh mesh = many_shells();
  append(box({0, 30, 0}, {60, 0.01, 0.01}, 6), mesh);
  append(box({0, 60, 0}, {60, 30, 0.01}, 6), mesh);
  Coarsening coarsening(mesh, 0.25);
  coarsening.coarsen(1);
  CHECK(coarsening.deviation().most <= 1);
  CHECK(coarsening.mesh().triangles.size() < 120);
}

TEST_CASE("repeated triangles are there once") {
  const bake::SourceMesh mesh = repeated(hills(12, 12));
  Coarsening coarsening(mesh, finest_cell_of(mesh));
  coarsening.coarsen(0.02);
  bake::SourceMesh coarse = coarsening.mesh();
  for (bake::TriangleCorners& corners : coarse.triangles) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  }
  std::sort(coarse.triangles.begin(), coarse.triangles.end());
  CHECK(std::adjacent_find(coarse.triangles.begin(), coarse.triangles.end()) ==
        coarse.triangles.end());
}

TEST_CASE("the same mesh gives the same coarse mesh, step by step") {
  const bake::SourceMesh mesh = wavy_ring(60, 20, 0.5);
  const double cell = finest_cell_of(mesh);
  Coarsening a(mesh, cell);
  Coarsening b(mesh, cell);
  for (const double limit : {0.2, 0.3}) {
    a.coarsen(limit);
    b.coarsen(limit);
    CHECK(a.mesh().vertices == b.mesh().vertices);
    CHECK(a.mesh().triangles == b.mesh().triangles);
  }
  const Coarsening copy = a;
  a.coarsen(1);
  CHECK(copy.mesh().triangles == b.mesh().triangles);
}

TEST_CASE("at a deadline coarsening ends, within its limit all the same") {
  const bake::SourceMesh mesh = wavy_ring(60, 20, 0.5);
  const double cell = finest_cell_of(mesh);
  std::size_t before = mesh.triangles.size();
  for (const int looks : {0, 40, 300, 1'000'000}) {
    Coarsening coarsening(mesh, cell);
    coarsening.coarsen(0.3, tool::after_looks(looks));
    CHECK(coarsening.is_unfinished() == (looks <= 300));
    CHECK(coarsening.deviation().most <= 0.3);
    CHECK((coarsening.triangle_count() < before) == (looks != 0));
    before = coarsening.triangle_count();
  }
  Coarsening all(mesh, cell);
  all.coarsen(0.3);
  CHECK(all.mesh().triangles.size() == before);
}

TEST_CASE("no more than half as many triangles again as the simplifier's own, which errs") {
  for (const Specimen& specimen : specimens()) {
    for (const double limit : {0.1, 0.5}) {
      CAPTURE(specimen.name, limit);
      Coarsening coarsening(specimen.mesh, finest_cell_of(specimen.mesh));
      const std::size_t estimate = coarsening.estimate(limit);
      coarsening.coarsen(limit);
      CHECK(2 * coarsening.mesh().triangles.size() <= 3 * estimate + 16);
    }
  }
}
