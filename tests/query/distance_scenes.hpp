// Pairs of meshes for tests of distances, near and far, and the distances of their triangles.
#pragma once

#include "flashbvh/clearance.hpp"
#include "flashbvh/detail/predicates/triangle_distance.hpp"
#include "support/any_mesh.hpp"
#include "support/oracles/float_distance.hpp"
#include "support/test.hpp"

namespace flashbvh::test {

using namespace flashbvh::detail;

using Found = Clearance<std::uint16_t>;
using Hint = Witness<std::uint16_t>;

/// From this offset on meshes are far, and from the next one on beyond the range.
constexpr std::int32_t kNear = 48000;
constexpr std::int32_t kFar = 1 << 20;

/// An offset next to the end of a range.
inline std::int32_t any_far_offset(Random& random) {
  constexpr std::int32_t at[] = {1 << 15, 40000,   kNear,          1 << 16,
                                 1 << 17, 1 << 18, (1 << 19) + 77, kFar - 1};
  const std::int32_t near = random.one_of(at);
  const std::int32_t offset = std::min(near + random.between(-1, 1), kFar - 1);
  return random.below(2) == 0 ? offset : -offset;
}

/// A pose far along at least one axis.
inline Pose any_far_pose(Random& random) {
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (std::int32_t& along : cells) {
    along = random.below(2) == 0 ? any_far_offset(random) : random.between(-kFar + 1, kFar - 1);
    along >>= random.below(3) == 0 ? random.below(18) : 0;
  }
  cells[random.below(3)] = any_far_offset(random);
  for (int axis = 0; axis < 3; ++axis) {  // half a cell less is still in range
    const std::int32_t part = random.between(0, 32767);
    fraction[axis] = static_cast<std::int16_t>(cells[axis] > 0 ? -part : part);
  }
  return random.below(2) == 0
             ? Pose::translated(cells[0], cells[1], cells[2])
             : Pose::rigid(rotation_of(any_quaternion(random)).entry, cells, fraction);
}

/// A pose that is turned, often as far from a rotation as a pose accepts.
inline Pose any_loose_pose(Random& random, std::int32_t far) {
  Rotation rotation = rotation_of(any_quaternion(random));
  const std::int32_t cells[3] = {random.between(-far, far), random.between(-far, far), 0};
  const Pose exact = Pose::rigid(rotation.entry, cells);
  for (auto& row : rotation.entry) {
    for (std::int32_t& entry : row) {
      entry += (random.below(8) == 0 ? -1 : 1) * (entry / 17000);
    }
  }
  const Pose loose = Pose::rigid(rotation.entry, cells);
  return loose.status() == Status::done && random.below(4) != 0 ? loose : exact;
}

inline bake::LatticeMesh one_triangle(const Vertex& p, const Vertex& q, const Vertex& r) {
  bake::LatticeMesh mesh;
  mesh.vertices = {p, q, r};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

inline std::int32_t rounded(double cells) {
  return static_cast<std::int32_t>(std::lround(cells));
}

/// Triangles about a corner, in two leaves, nearly in the plane across `up` there.
inline AnyMesh fan(Random& random, const FloatVector& up, std::int32_t reach) {
  bake::LatticeMesh mesh;
  mesh.vertices = {{0, 0, 0}};
  for (std::uint32_t i = 1; i < 13; ++i) {
    FloatVector corner = {};
    for (double& along : corner) {
      along = reach * (random.between(-1000, 1000) / 1000.0);
    }
    const double height = random.between(-reach / 50 - 4, 1);
    corner = plus(corner, height - test::dot(corner, up), up);
    mesh.vertices.push_back(
        vertex_of({rounded(corner[0]), rounded(corner[1]), rounded(corner[2])}));
    if (i % 2 == 0) {
      mesh.triangles.push_back({0, i - 1, i});
    }
  }
  return AnyMesh(bake::build_median(mesh, 3), mesh);
}

/// A point above the middle of a triangle, `height` off its plane.
inline Vertex above(const Vertex& p, const Vertex& q, const Vertex& r, double height) {
  const FloatVector corner = vector_of<double>(p);
  const FloatVector u = minus(vector_of<double>(q), corner);
  const FloatVector v = minus(vector_of<double>(r), corner);
  const FloatVector n = cross(u, v);
  const FloatVector middle = plus(plus(corner, 1.0 / 3, u), 1.0 / 3, v);
  const FloatVector point = plus(middle, height / (length_of(n) + 1e-9), n);
  const auto at = [&](std::size_t axis) {
    return rounded(std::clamp<double>(point[axis], -kMaxCoordinate, kMaxCoordinate));
  };
  return vertex_of({at(0), at(1), at(2)});
}

struct Pairwise {
  Fraction squared;
  std::uint16_t of_a;  ///< slots
  std::uint16_t of_b;
  std::uint32_t id_a;
  std::uint32_t id_b;
};

/// The distances of all pairs of triangles, by slot in A, then in B.
inline std::vector<Pairwise> all_distances(const Mesh& a, const Mesh& b, const Pose& pose) {
  std::vector<Pairwise> all;
  for_all_pairs(
      a, a.triangle_count, b, b.triangle_count, pose,
      [&](std::uint32_t i, std::uint32_t j, const Triangle& of_a, const Triangle& of_b) {
        Fraction squared = kInfinite;
        Features features{};
        REQUIRE(is_nearer(of_a, of_b, squared, features));
        all.push_back({squared, static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j),
                       a.triangle_ids[i], b.triangle_ids[j]});
      });
  return all;
}

inline const Pairwise& least_of(const std::vector<Pairwise>& all) {
  return *std::min_element(all.begin(), all.end(), [](const Pairwise& p, const Pairwise& q) {
    return compare(p.squared, q.squared) < 0;
  });
}

/// In 1/256 cell, rounded down.
inline std::uint32_t lower_of(const Fraction& squared) {
  return static_cast<std::uint32_t>(
      square_root(quotient(shifted_up(squared.above, 16), squared.below)));
}

/// In cells, to the last bits of a double.
inline double root_of(const Fraction& squared) {
  const auto number = [](const Int128& u) {
    return std::ldexp(static_cast<double>(u.high), 64) + static_cast<double>(u.low);
  };
  return std::sqrt(number(squared.above) / number(squared.below));
}

/// Two meshes, and the distances of all pairs of their triangles.
struct Pairing {
  AnyMesh a;
  AnyMesh b;
  Pose pose;
  std::vector<Pairwise> all = all_distances(a, b, pose);

  /// Meshes of up to `most` triangles.
  static Pairing any(Random& random, std::uint32_t most, bool is_far) {
    const std::int32_t spreads[] = {5, 60, 1000, 15000};
    const std::int32_t spread = random.one_of(spreads);
    const std::int32_t reach = spread > 6000 ? 23000 : spread * random.between(1, 4);
    AnyMesh a = any_mesh(random, most, spread, 1 + spread / 4);
    AnyMesh b = any_mesh(random, most, spread, 1 + spread / 4);
    return {std::move(a), std::move(b), is_far ? any_far_pose(random) : any_pose(random, reach)};
  }
  /// A triangle, and a point above its middle or another triangle: bounds by leaves are tight.
  static Pairing of_leaves(Random& random) {
    const std::int32_t reach = 1 << (3 + random.below(11));
    const Vertex p = any_vertex(random, reach);
    const Vertex q = any_vertex(random, reach);
    const Vertex r = any_vertex(random, reach);
    const Vertex point = above(p, q, r, random.between(0, 16000));
    const Vertex u = any_vertex(random, 16000);
    const bool is_point = random.below(3) != 0;
    AnyMesh triangle = any_mesh(random, one_triangle(p, q, r));
    AnyMesh other = any_mesh(random, is_point ? one_triangle(point, point, point)
                                              : one_triangle(u, point, any_vertex(random, 16000)));
    const Pose pose = any_loose_pose(random, random.below(4) == 0 ? 20000 : 0);
    return random.below(2) == 0 ? Pairing{std::move(triangle), std::move(other), pose}
                                : Pairing{std::move(other), std::move(triangle), pose};
  }
  /// Fans that face each other: most pairs of leaves have ties alone.
  static Pairing of_fans(Random& random) {
    const Pose turn = any_pose(random, 0);
    const std::int32_t reach = 40 << random.below(9);
    FloatVector apart = {};
    for (double& along : apart) {
      along = random.between(-1000, 1000) + 0.5;
    }
    const FloatVector up = times(1 / length_of(apart), apart);
    FloatVector down = {};  // in B's lattice
    for (unsigned i = 0; i < 9; ++i) {
      down[i % 3] -= up[i / 3] * turn.rotation(int(i / 3), int(i % 3)) / kRotationOne;
    }
    AnyMesh a = fan(random, up, reach);
    AnyMesh b = fan(random, down, reach);
    const FloatVector to = times(random.between(reach / 40 + 2, reach), up);
    const Pose from = Pose::translated(-rounded(to[0]), -rounded(to[1]), -rounded(to[2]));
    return {std::move(a), std::move(b), Pose::relative(from, turn)};
  }
  Hint any_hint(Random& random) const {
    const Pairwise& pair = random.one_of(all);
    return {pair.of_a, pair.of_b};
  }
};

}  // namespace flashbvh::test
