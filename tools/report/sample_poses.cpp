// Rotations from quaternions of four integers in a ball, which makes them even over all rotations
// (Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992); directions likewise from three.
// Integers alone, rounded the same everywhere.
#include "report/sample_poses.hpp"

#include <array>

#include "report/square_root.hpp"

namespace flashbvh::report {
namespace {

constexpr std::int64_t kRadius = 20000;

/// Evenly in a ball, but not near its middle, where rounding would show.
template <std::size_t dimensions>
std::array<std::int64_t, dimensions> in_ball(Random& random) {
  for (;;) {
    std::array<std::int64_t, dimensions> point{};
    std::int64_t square = 0;
    for (std::int64_t& part : point) {
      part = random.within(kRadius);
      square += part * part;
    }
    if (square <= kRadius * kRadius && square >= kRadius * kRadius / 16) {
      return point;
    }
  }
}

using Matrix = std::int32_t[3][3];

void set_rotation(const std::array<std::int64_t, 4>& q, Matrix& matrix) {
  const auto [w, x, y, z] = q;
  const std::int64_t square = w * w + x * x + y * y + z * z;
  const std::int64_t over[3][3] = {
      {w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w)},
      {2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w)},
      {2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z}};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      // At most 2^29 times 2^30.
      matrix[row][column] = static_cast<std::int32_t>(over[row][column] * kRotationOne / square);
    }
  }
}

}  // namespace

std::int64_t Random::within(std::int64_t most) {
  const auto count = static_cast<std::uint64_t>(2 * most + 1);
  return static_cast<std::int64_t>(((next() >> 32) * count) >> 32) - most;
}

std::uint64_t Random::next() {
  std::uint64_t bits = (state_ += 0x9E3779B97F4A7C15u);
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  return bits ^ (bits >> 31);
}

PoseSampler::PoseSampler(const tool::AnyTree& a, const tool::AnyTree& b)
    : a_(place_of(a)), b_(place_of(b)) {}

PoseSampler::Place PoseSampler::place_of(const tool::AnyTree& any) {
  return std::visit(
      [](const auto& tree) {
        const detail::Box box = detail::unpack(tree.nodes[0].box);
        const Vector lower = {box.lower.x, box.lower.y, box.lower.z};
        const Vector upper = {box.upper.x, box.upper.y, box.upper.z};
        Place place{};
        Vector sides{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          place.middle[axis] = 2 * std::int64_t{tree.origin[axis]} + lower[axis] + upper[axis];
          sides[axis] = upper[axis] - lower[axis];
        }
        place.diagonal = square_root(dot(sides, sides)) + 1;
        return place;
      },
      any);
}

Pose PoseSampler::next() {
  Matrix rotation;
  set_rotation(in_ball<4>(random_), rotation);
  const Vector direction = in_ball<3>(random_);
  const std::int64_t reach = a_.diagonal + b_.diagonal;
  const std::int64_t distance = (random_.within(reach) + reach) / 2;
  const std::int64_t length = square_root(dot(direction, direction));
  // What a pose keeps of the rotation: far from the origin, the rest would count.
  const Pose turned = Pose::rigid(rotation, {0, 0, 0});
  std::int32_t cells[3];
  for (int axis = 0; axis < 3; ++axis) {
    const Vector row = {turned.rotation(axis, 0), turned.rotation(axis, 1),
                        turned.rotation(axis, 2)};
    const auto i = static_cast<std::size_t>(axis);
    const std::int64_t middle = a_.middle[i] + direction[i] * distance / length;
    cells[axis] = static_cast<std::int32_t>((middle - dot(row, b_.middle) / kRotationOne) / 2);
  }
  return Pose::rigid(rotation, cells);
}

}  // namespace flashbvh::report
