// Rotations from quaternions of four integers in a ball, which are uniform over all rotations
// (Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992); directions from three integers
// in a ball. Integer arithmetic only, so results are the same everywhere.
#include "report/page.hpp"

#include <array>
#include <cstdint>

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "evaluate/random.hpp"
#include "report/subject.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::int64_t kRadius = 20000;

using Vector = LatticePoint;

std::int64_t dot(const Vector& u, const Vector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// The largest integer whose square is at most `value`, 0 to 2^62 - 1.
std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;  // below 2^31
  for (std::int64_t bit = std::int64_t{1} << 30; bit != 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) {
      root += bit;
    }
  }
  return root;
}

/// Uniform in a ball, but not near its centre, where rounding would be visible.
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

/// A root's box; `middle` in half cells of the mesh's frame.
struct Place {
  explicit Place(const AnyTree& any) {
    const NodeBox box = root_box(any);
    Vector sides{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middle[axis] = box.lower[axis] + box.upper[axis];
      sides[axis] = box.upper[axis] - box.lower[axis];
    }
    diagonal = square_root(dot(sides, sides)) + 1;
  }

  Vector middle{};
  std::int64_t diagonal = 0;  ///< half of it
};

/// A pose up to the sum of half the diagonals away: farther boxes are disjoint under any rotation.
/// Its status is not `done` if a mesh lies too far from its origin.
Pose next_pose(Random& random, const Place& a, const Place& b) {
  Matrix rotation;
  set_rotation(in_ball<4>(random), rotation);
  const Vector direction = in_ball<3>(random);
  const std::int64_t reach = a.diagonal + b.diagonal;
  const std::int64_t distance = (random.within(reach) + reach) / 2;
  const std::int64_t length = square_root(dot(direction, direction));
  // Uses the rotation as the pose rounds it: far from the origin, the rounding error would count.
  const Pose rotated = Pose::rigid(rotation, {0, 0, 0});
  std::int32_t cells[3];
  for (int axis = 0; axis < 3; ++axis) {
    const Vector row = {rotated.rotation(axis, 0), rotated.rotation(axis, 1),
                        rotated.rotation(axis, 2)};
    const auto i = static_cast<std::size_t>(axis);
    const std::int64_t middle = a.middle[i] + direction[i] * distance / length;
    cells[axis] = static_cast<std::int32_t>((middle - dot(row, b.middle) / kRotationOne) / 2);
  }
  return Pose::rigid(rotation, cells);
}

Closeness closeness_of(const WideCounts& counts) {
  if (counts.triangle_pairs != 0) {
    return kIntersecting;
  }
  if (counts.leaf_pairs != 0) {
    return kCloseProximity;
  }
  return counts.overlaps != 0 ? kSmallProximity : kSeparated;
}

/// Adds the costs of a query at the pose; returns its visits.
std::uint64_t add(PairCosts& costs, const ImageFile& a, const ImageFile& b, const Pose& pose,
                  const std::string& place) {
  const char* const algorithm = default_traversal(a.layout());
  const Answer all = collide(a.tree(), b.tree(), pose, algorithm, {});
  check_answered(all, place, costs.poses.size());
  costs.poses.push_back(
      {pose, closeness_of(all.counts), all.work, all.work, all.counts.triangle_pairs});
  if (all.counts.triangle_pairs == 0) {
    return all.counts.visits;
  }
  const Answer first = collide(a.tree(), b.tree(), pose, algorithm, {/*first=*/true, false});
  costs.poses.back().work_to_first = first.work;
  return all.counts.visits + first.counts.visits;
}

void sum_up(PairCosts& costs, const ImageFile& a, const ImageFile& b) {
  costs.bound = visit_bound(a.tree(), b.tree(), default_traversal(a.layout()));
  std::vector<std::uint64_t> work;
  std::vector<std::uint64_t> to_first;
  for (const PoseCost& pose : costs.poses) {
    work.push_back(pose.work);
    to_first.push_back(pose.work_to_first);
  }
  if (!work.empty()) {
    costs.needed = needed_work(std::move(work));
    costs.needed_to_first = needed_work(std::move(to_first));
  }
}

}  // namespace

PairCosts costs_at(const ImageFile& a, const ImageFile& b, const std::string& path) {
  PairCosts costs;
  costs.are_given = true;
  for (const Pose& pose : read_lattice_poses(path, a.cell())) {
    add(costs, a, b, pose, path);
  }
  sum_up(costs, a, b);
  return costs;
}

PairCosts sampled_costs(const ImageFile& a, const ImageFile& b, std::size_t count) {
  const Place place_a(a.tree());
  const Place place_b(b.tree());
  Random random;
  PairCosts costs;
  std::uint64_t spent = 0;
  for (std::size_t i = 0; i < count && !costs.costly; ++i) {
    const Pose pose = next_pose(random, place_a, place_b);
    if (pose.status() != Status::done) {
      ++costs.out_of_range;
      continue;
    }
    spent += add(costs, a, b, pose, b.path());
    costs.costly = spent >= kMostVisits && i + 1 < count;
  }
  sum_up(costs, a, b);
  return costs;
}

}  // namespace flashbvh::tool
