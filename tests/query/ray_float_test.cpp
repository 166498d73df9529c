// Rays given in floats: their ends against double precision, and invalid rays.
#include "flashbvh/float.hpp"
#include "support/test.hpp"

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
    const auto x = static_cast<double>(direction[0]);
    const auto y = static_cast<double>(direction[1]);
    const auto z = static_cast<double>(direction[2]);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length == 0) {
      REQUIRE(made.status == Status::ray_out_of_range);
      return;
    }
    CAPTURE(origin[0], origin[1], origin[2], x, y, z, reach, cells);
    REQUIRE(made.status == Status::done);
    const auto scaling = static_cast<double>(cells);
    const double way[3] = {x / length, y / length, z / length};
    const std::int32_t from[3] = {made.segment.from.x, made.segment.from.y, made.segment.from.z};
    const std::int32_t to[3] = {made.segment.to.x, made.segment.to.y, made.segment.to.z};
    for (int i = 0; i < 3; ++i) {
      const double start = static_cast<double>(origin[i]) * scaling;
      REQUIRE(std::fabs(from[i] - start) <= 0.50001);
      REQUIRE(std::fabs(to[i] - (start + static_cast<double>(reach) * scaling * way[i])) <= 0.51);
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
  const auto status = [](float x, float direction, float reach, float cells) {
    return segment_of({x, 0, 0}, {direction, 0, 0}, reach, cells).status;
  };
  CHECK(status(1, 1, 1, 1) == Status::done);
  CHECK(status(1, 0, 1, 1) == Status::ray_out_of_range);
  CHECK(status(1, -0.0f, 1, 1) == Status::ray_out_of_range);
  CHECK(status(1, 1, -1, 1) == Status::ray_out_of_range);
  CHECK(status(1, 1, -1e-9f, 1) == Status::ray_out_of_range);
  CHECK(status(1, 1, -0.0f, 1) == Status::done);
  CHECK(fine_distance(-1e-9f, 1) == UINT32_MAX);
  CHECK(fine_distance(-0.0f, 1) == 0);
  CHECK(status(1, 1, 1.1e6f, 1) == Status::ray_out_of_range);
  CHECK(status(6e8f, 1, 1, 1) == Status::ray_out_of_range);
  CHECK(status(-6e8f, 1, 1, 1) == Status::ray_out_of_range);
  CHECK(status(1, 1, 1, 0) == Status::ray_out_of_range);
  CHECK(status(1, 1, 1, -1) == Status::ray_out_of_range);
  for (const float bad : {infinite, -infinite, nan}) {
    CHECK(status(bad, 1, 1, 1) == Status::ray_out_of_range);
    CHECK(status(1, bad, 1, 1) == Status::ray_out_of_range);
    CHECK(status(1, 1, bad, 1) == Status::ray_out_of_range);
    CHECK(status(1, 1, 1, bad) == Status::ray_out_of_range);
  }
}
