// Rays given in floats: their ends against double precision, and invalid rays.
#include "flashbvh/float.hpp"
#include "support/test.hpp"
#include "support/vectors.hpp"

namespace {

float any_float(Random& random, float reach) {
  return reach * (static_cast<float>(random.between(-1'000'000, 1'000'000)) * 1e-6f);
}

}  // namespace

TEST_CASE("a ray of floats ends within half a cell of where it should") {
  for_rounds(3000, [&](Random& random, int round) {
    const float scale = std::ldexp(1.0f, random.between(-120, 120));
    const float cells = 1 + any_float(random, 0.5f);
    const float origin[3] = {any_float(random, 1e5f), any_float(random, 1e5f),
                             any_float(random, 1e5f)};
    const float direction[3] = {any_float(random, scale), any_float(random, scale),
                                random.below(4) == 0 ? 0 : any_float(random, scale)};
    const float reach = std::fabs(any_float(random, round % 2 == 0 ? 3e5f : 30));
    const MadeSegment made = segment_of(origin, direction, reach, cells);
    const auto wide = [](float value) { return static_cast<double>(value); };
    const FloatVector along = {wide(direction[0]), wide(direction[1]), wide(direction[2])};
    const double length = length_of(along);
    if (length == 0) {
      REQUIRE(made.status == Status::ray_out_of_range);
      return;
    }
    CAPTURE(origin[0], origin[1], origin[2], along[0], along[1], along[2], reach, cells);
    REQUIRE(made.status == Status::done);
    const double scaling = wide(cells);
    const auto from = vector_of<double>(made.segment.from);
    const auto to = vector_of<double>(made.segment.to);
    for (std::size_t i = 0; i < 3; ++i) {
      const double start = wide(origin[i]) * scaling;
      const double end = start + wide(reach) * scaling * along[i] / length;
      REQUIRE(std::fabs(from[i] - start) <= 0.50001);
      REQUIRE(std::fabs(to[i] - end) <= 0.51);
    }
  });
}

TEST_CASE("axes and lengths are exact, whatever the direction's length") {
  const float origin[3] = {1, 2, 3};
  for (const float size : {1e-40f, 1e-3f, 1.0f, 7.0f, 3e38f}) {
    const MadeSegment made = segment_of(origin, {0, -size, 0}, 5, 100);
    REQUIRE(made.status == Status::done);
    CHECK((made.segment.from.x == 100 && made.segment.from.y == 200 && made.segment.from.z == 300));
    CHECK((made.segment.to.x == 100 && made.segment.to.y == -300 && made.segment.to.z == 300));
  }
  const MadeSegment made = segment_of(origin, {3, 4, 0}, 10, 1);
  CHECK((made.segment.to.x == 7 && made.segment.to.y == 10 && made.segment.to.z == 3));
  const MadeSegment none = segment_of(origin, {3, 4, 0}, 0, 1);
  CHECK((none.status == Status::done && none.segment.to.x == 1 && none.segment.to.z == 3));
}

TEST_CASE("what is no ray is refused") {
  const float infinite = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  // A coordinate, the direction, the length, cells per unit.
  const auto status = [](const float(&row)[4]) {
    return segment_of({row[0], 0, 0}, {row[1], 0, 0}, row[2], row[3]).status;
  };
  CHECK(status({1, 1, 1, 1}) == Status::done);
  CHECK(status({1, 1, -0.0f, 1}) == Status::done);
  const float refused[][4] = {{1, 0, 1, 1},      {1, -0.0f, 1, 1},  {1, 1, -1, 1},
                              {1, 1, -1e-9f, 1}, {1, 1, 1.1e6f, 1}, {6e8f, 1, 1, 1},
                              {-6e8f, 1, 1, 1},  {1, 1, 1, 0},      {1, 1, 1, -1}};
  for (const auto& row : refused) {
    CHECK(status(row) == Status::ray_out_of_range);
  }
  for (const float bad : {infinite, -infinite, nan}) {
    for (int i = 0; i < 4; ++i) {
      float row[4] = {1, 1, 1, 1};
      row[i] = bad;
      CHECK(status(row) == Status::ray_out_of_range);
    }
  }
}
