// The certificate: never below the samples, and hardly above them.
#include "simplify/deviation.hpp"

#include "simplify/zoo.hpp"

using namespace flashbvh::test;
using simplify::Deviation;
using simplify::deviation_from;
using simplify::NearestTriangle;

namespace {

/// The mesh with each coordinate moved by up to `most`.
bake::SourceMesh shaken(bake::SourceMesh mesh, double most, Random& random) {
  for (auto& vertex : mesh.vertices) {
    for (double& coordinate : vertex) {
      coordinate += most * random.between(-1000, 1000) / 1000.0;
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a triangle on a line is as near as its ends, however doubles round its area") {
  for_rounds(1000, 3, [](Random& random, int) {
    const double step = random.between(1, 1000) / 777.0;
    const simplify::Point along = {random.between(-9, 9) / 7.0, random.between(-9, 9) / 7.0, 1};
    const auto at = [&](double times) {
      return simplify::Point{times * step * along[0], times * step * along[1],
                             times * step * along[2]};
    };
    const double length = std::hypot(along[0], along[1], along[2]) * step;
    const simplify::PointTriangle triangle = {at(0), at(33), at(15)};
    const double beyond = random.between(0, 100) / 10.0;
    for (const simplify::Point& point : {at(33 + beyond), at(-beyond)}) {
      const double distance = std::sqrt(simplify::squared_distance(point, triangle));
      REQUIRE(std::fabs(distance - beyond * length) <= 1e-9);
    }
  });
}

TEST_CASE("no sample is farther than the certificate says, and it says hardly more") {
  const int samples = is_thorough() ? 1'000'000 : 1000;
  for_rounds(3, 2, [&](Random& random, int round) {
    const bake::SourceMesh mesh = round % 3 == 0   ? wavy_ring(20, 8, 1)
                                  : round % 3 == 1 ? hills(20, 12)
                                                   : many_shells();
    const double limit = 0.5 * (1 + round % 4);
    const bake::SourceMesh coarse = shaken(mesh, limit / 2, random);
    const NearestTriangle nearest(coarse);
    const Deviation deviation = deviation_from(nearest, mesh, limit);
    double most = distance_by_force(deviation.where, coarse);
    CHECK(std::fabs(most - deviation.at_least) < 1e-9);
    for (const auto& vertex : mesh.vertices) {
      most = std::max(most, distance_by_force(vertex, coarse));
    }
    for (int i = 0; i < samples; ++i) {
      most = std::max(most, distance_by_force(any_point_of(random, mesh), coarse));
    }
    CHECK(deviation.most >= most * (1 - 1e-12));
    CHECK(deviation.most <= 1.1 * most);
    CHECK(deviation.at_least <= deviation.most);
    CHECK(deviation_from(nearest, mesh, most / 2).most == HUGE_VAL);
    std::vector<simplify::CoveredPart> parts;
    CHECK(deviation_from(nearest, mesh, limit, &parts).most <= limit);
    CHECK(parts.size() >= mesh.triangles.size());
    for (const simplify::CoveredPart& part : parts) {
      for (const auto& corner : part.part) {
        REQUIRE(simplify::squared_distance(corner, nearest.triangle(part.by)) <= limit * limit);
      }
    }
  });
}

TEST_CASE("what is farther between its vertices than at them is seen") {
  // A roof over a floor: the floor's vertices lie on the roof, its middle far below the ridge.
  const bake::SourceMesh roof = {
      {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 0, 4}, {5, 10, 4}},
      {{0, 4, 5}, {0, 5, 3}, {4, 1, 2}, {4, 2, 5}}};
  const bake::SourceMesh floor = {{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}},
                                  {{0, 1, 2}, {0, 2, 3}}};
  const Deviation deviation = deviation_from(NearestTriangle(roof), floor, 10);
  const double truth = 5 * 4 / std::hypot(4.0, 5.0);  // of (5, y, 0) from either side
  CHECK(deviation.most >= truth);
  CHECK(deviation.most <= 1.05 * truth);
  CHECK(deviation_from(NearestTriangle(roof), floor, 0.99 * truth).most == HUGE_VAL);
  CHECK(deviation_from(NearestTriangle(roof), floor, 1.01 * truth).most <= 1.01 * truth);
}
