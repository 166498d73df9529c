#include "support/torus.hpp"

#include <cmath>

namespace flashbvh::test {
namespace {

constexpr double kTurn = 6.283185307179586;

/// The sine of step / steps of a turn, rounded to 2^-24, so that it does not depend on the last bit
/// of the C library's result.
double sine(std::uint32_t step, std::uint32_t steps) {
  return std::round(std::sin(kTurn * step / steps) * 16777216.0) / 16777216.0;
}

double cosine(std::uint32_t step, std::uint32_t steps) {
  return std::round(std::cos(kTurn * step / steps) * 16777216.0) / 16777216.0;
}

std::int16_t rounded(double value) {
  return static_cast<std::int16_t>(std::lround(value));
}

}  // namespace

bake::LatticeMesh torus(std::uint32_t around, std::uint32_t across, double ring, double tube) {
  bake::LatticeMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double radius = ring + tube * cosine(j, across);
      mesh.vertices.push_back({rounded(radius * cosine(i, around)),
                               rounded(radius * sine(i, around)), rounded(tube * sine(j, across))});
    }
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    return (i % around) * across + j % across;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace flashbvh::test
