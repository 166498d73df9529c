// Rotations from quaternions of four integers in a ball, which makes them even over all rotations
// (Shoemake, "Uniform Random Rotations", Graphics Gems III, 1992); directions likewise from three.
// Integers alone, rounded the same everywhere.
#include "report/visits.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "evaluate/queries.hpp"
#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "report/view.hpp"

namespace flashbvh::tool {
namespace {

/// The splitmix64 generator (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014), always from the same start.
class Random {
 public:
  /// From -most to most.
  std::int64_t within(std::int64_t most) {
    const auto count = static_cast<std::uint64_t>(2 * most + 1);
    return static_cast<std::int64_t>(((next() >> 32) * count) >> 32) - most;
  }

 private:
  std::uint64_t next() {
    std::uint64_t bits = (state_ += 0x9E3779B97F4A7C15u);
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
  }

  std::uint64_t state_ = 1;
};

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

/// A root's box, in half cells of the mesh's frame.
struct Place {
  explicit Place(const AnyTree& any) {
    std::visit(
        [this](const auto& tree) {
          const detail::Box box = detail::unpack(tree.nodes[0].box);
          const Vector lower = {box.lower.x, box.lower.y, box.lower.z};
          const Vector upper = {box.upper.x, box.upper.y, box.upper.z};
          Vector sides{};
          for (std::size_t axis = 0; axis < 3; ++axis) {
            middle[axis] = 2 * std::int64_t{tree.origin[axis]} + lower[axis] + upper[axis];
            sides[axis] = upper[axis] - lower[axis];
          }
          diagonal = square_root(dot(sides, sides)) + 1;
        },
        any);
  }

  Vector middle{};
  std::int64_t diagonal = 0;  ///< half of it
};

/// B rotated by any rotation, each as likely as the other, and translated so that the middle of its
/// box lies in any direction from the middle of A's, at any distance from 0 to the sum of half
/// their boxes' diagonals: from there on their boxes are disjoint however they are rotated. Always
/// the same poses for the same trees; not `done` where a mesh lies too far from its origin.
Pose next_pose(Random& random, const Place& a, const Place& b) {
  Matrix rotation;
  set_rotation(in_ball<4>(random), rotation);
  const Vector direction = in_ball<3>(random);
  const std::int64_t reach = a.diagonal + b.diagonal;
  const std::int64_t distance = (random.within(reach) + reach) / 2;
  const std::int64_t length = square_root(dot(direction, direction));
  // What a pose keeps of the rotation: far from the origin, the rest would count.
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

void add(Visits& visits, std::uint64_t count) {
  ++visits.poses;
  visits.sum += count;
  visits.most = std::max(visits.most, count);
}

bool is_full(const VisitSample& sample, std::uint64_t wanted) {
  return std::all_of(sample.all.begin(), sample.all.end(),
                     [&](const Visits& visits) { return visits.poses == wanted; });
}

}  // namespace

VisitSample sample_visits(const ImageFile& a, const ImageFile& b, std::uint64_t wanted) {
  const char* const algorithm = default_traversal(a.layout());
  const Place place_a(a.tree());
  const Place place_b(b.tree());
  Random random;
  VisitSample sample;
  std::uint64_t spent = 0;
  for (std::uint64_t i = 0; i < kTries * wanted && !is_full(sample, wanted); ++i) {
    const Pose pose = next_pose(random, place_a, place_b);
    if (pose.status() != Status::done) {
      ++sample.out_of_range;
      continue;
    }
    // The first pair tells the class; only a pose that is wanted is worth all pairs.
    WideCounts counts = collide(a.tree(), b.tree(), pose, algorithm, true).counts;
    const Closeness closeness = closeness_of(counts);
    spent += counts.visits;
    if (sample.all[closeness].poses < wanted) {
      if (closeness == kIntersecting) {
        add(sample.first, counts.visits);
        counts = collide(a.tree(), b.tree(), pose, algorithm, false).counts;
        spent += counts.visits;
      }
      add(sample.all[closeness], counts.visits);
    }
    if (spent >= kMostVisits) {
      sample.costly = true;
      break;
    }
  }
  return sample;
}

}  // namespace flashbvh::tool
