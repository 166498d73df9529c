// Queries with answers known by construction: meshes that touch in a point or are within a cell of
// it, distances of boxes, and rays through vertices and edges of a mesh. All numbers are integers
// below 2^24, or their quotients by 1,024: binary32 holds each.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "comparison.hpp"

using flashbvh::Mesh;
using flashbvh::Point;
using flashbvh::test::Random;

namespace compare {
namespace {

constexpr std::size_t kQueries = 2000;  ///< per kind and pair of meshes

constexpr std::int64_t kFarthest = 400000;  ///< distance of a ray's ends

using Cells = std::array<std::int64_t, 3>;

std::int64_t product(const Cells& a, const Cells& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Cells vertex_of(const Mesh& mesh, std::uint32_t i) {
  const flashbvh::Vertex& v = mesh.vertices[i];
  return {mesh.origin[0] + v.x, mesh.origin[1] + v.y, mesh.origin[2] + v.z};
}

/// The farthest vertex along `way`.
Cells farthest(const Mesh& mesh, const Cells& way) {
  Cells best = vertex_of(mesh, 0);
  for (std::uint32_t i = 1; i < mesh.vertex_count; ++i) {
    const Cells vertex = vertex_of(mesh, i);
    best = product(vertex, way) > product(best, way) ? vertex : best;
  }
  return best;
}

/// One of the 24 rotations of a cube, so that no vertex is rounded.
flashbvh::test::Rotation any_turn(Random& random) {
  const auto quarter = [&random] {
    flashbvh::test::Quaternion q{};
    std::int32_t* const part[] = {&q.x, &q.y, &q.z};
    q.w = random.between(-1, 1);
    *part[random.below(3)] = q.w == 0 ? 1 : random.between(-1, 1);
    return flashbvh::test::rotation_of(q);
  };
  const flashbvh::test::Rotation first = quarter();
  const flashbvh::test::Rotation second = quarter();
  flashbvh::test::Rotation both{};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      for (int k = 0; k < 3; ++k) {
        both.entry[row][column] +=
            first.entry[row][k] / flashbvh::kRotationOne * second.entry[k][column];
      }
    }
  }
  return both;
}

Cells turned(const flashbvh::test::Rotation& turn, const Cells& cells) {
  Cells out{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      out[row] += turn.entry[row][column] / flashbvh::kRotationOne * cells[column];
    }
  }
  return out;
}

Placed placed(const flashbvh::test::Rotation& turn, const Cells& at) {
  Placed pose{turn, {}, flashbvh::Pose::translated(0, 0, 0)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.cells[axis] = static_cast<std::int32_t>(at[axis]);
  }
  pose.pose = flashbvh::Pose::rigid(turn.entry, pose.cells);
  return pose;
}

Cells any_way(Random& random, bool along_axis) {
  Cells way{};
  if (along_axis) {
    way[random.below(3)] = random.below(2) == 0 ? 1 : -1;
    return way;
  }
  for (std::int64_t& part : way) {
    part = random.between(-1000, 1000);
  }
  way[0] += way[0] == 0 ? 1 : 0;
  return way;
}

/// Puts B's farthest vertex against `way` on A's farthest vertex along `way`: a plane separates the
/// meshes except for these vertices. With `gap`, B is one cell farther away.
Placed any_touching(const Mesh& a, const Mesh& b, bool gap, Random& random) {
  const flashbvh::test::Rotation turn = any_turn(random);
  const Cells way = any_way(random, random.below(2) == 0);
  // The direction in B's frame, by the transposed rotation.
  Cells back{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      back[column] -= turn.entry[row][column] / flashbvh::kRotationOne * way[row];
    }
  }
  const Cells of_a = farthest(a, way);
  const Cells of_b = turned(turn, farthest(b, back));
  Cells at{};
  std::size_t longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = of_a[axis] - of_b[axis];
    longest = std::abs(way[axis]) > std::abs(way[longest]) ? axis : longest;
  }
  at[longest] += !gap ? 0 : way[longest] > 0 ? 1 : -1;
  return placed(turn, at);
}

void query_touching(const std::string& names, const Mesh& a, const Mesh& b) {
  const std::pair<const char*, std::unique_ptr<Collider>> libraries[] = {
      {"flashbvh", with_flashbvh(a, b, PoseMade::before)},
      {"opcode", with_opcode(a, b, Matrices::both)},
      {"fcl", with_fcl(a, b)},
      {"bullet", with_bullet(a, b)}};
  for (const bool gap : {false, true}) {
    Random random(kSeed);
    std::vector<Placed> poses;
    for (std::size_t i = 0; i < kQueries; ++i) {
      poses.push_back(any_touching(a, b, gap, random));
    }
    for (const auto& [name, library] : libraries) {
      library->set_poses(poses);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < kQueries; ++i) {
        wrong += library->pairs(i).empty() != gap ? 1 : 0;
      }
      std::printf("known %s %s %s %zu %zu\n", gap ? "gap" : "touching", names.c_str(), name,
                  kQueries, wrong);
    }
  }
}

/// The distance of axis-aligned boxes, with B at `at`.
double distance_of_boxes(const Mesh& a, const Mesh& b, const Cells& at) {
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Cells way{};
    way[axis] = 1;
    Cells back{};
    back[axis] = -1;
    const auto above = farthest(b, back)[axis] + at[axis] - farthest(a, way)[axis];
    const auto below = farthest(a, back)[axis] - farthest(b, way)[axis] - at[axis];
    const auto gap = static_cast<double>(std::max({std::int64_t{0}, above, below}));
    square += gap * gap;
  }
  return std::sqrt(square);
}

void query_distances(const std::string& names, const Mesh& a, const Mesh& b) {
  const flashbvh::test::Rotation none = flashbvh::test::rotation_of({1, 0, 0, 0});
  Random random(kSeed);
  std::vector<Placed> poses;
  std::vector<double> lengths;
  while (poses.size() < kQueries) {
    const Cells at = {random.between(-4000, 4000), random.between(-4000, 4000),
                      random.between(-4000, 4000)};
    const double length = distance_of_boxes(a, b, at);
    if (length > 0) {
      poses.push_back(placed(none, at));
      lengths.push_back(length);
    }
  }
  const std::pair<const char*, std::unique_ptr<DistanceMeter>> libraries[] = {
      {"flashbvh", distances_of_flashbvh(a, b, Hint::none)},
      {"fcl", distances_of_fcl(a, b, Volumes::boxes_and_spheres)},
      {"fcl_rss", distances_of_fcl(a, b, Volumes::spheres)}};
  for (const auto& [name, library] : libraries) {
    library->set_poses(poses);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < kQueries; ++i) {
      const Length found = library->length(i);
      const double allowed = 1e-6 * lengths[i];
      wrong += found.lower > lengths[i] + allowed || found.upper < lengths[i] - allowed ? 1 : 0;
    }
    std::printf("known distance %s %s %zu %zu\n", names.c_str(), name, kQueries, wrong);
  }
}

/// A segment whose middle is `twice` / 2.
flashbvh::Segment any_segment(const Cells& twice, Random& random) {
  const auto part = [&random] { return random.between(-100000, 100000); };
  const Cells from = {part(), part(), part()};
  const auto point = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return Point{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                 static_cast<std::int32_t>(z)};
  };
  return {point(from[0], from[1], from[2]),
          point(twice[0] - from[0], twice[1] - from[1], twice[2] - from[2])};
}

/// A segment in a plane at most a cell beyond the farthest vertex along `way`: it hits nothing.
flashbvh::Segment any_beside(const Mesh& mesh, Random& random) {
  const Cells way = any_way(random, /*along_axis=*/false);
  const Cells other = {random.between(-200, 200), random.between(-200, 200),
                       random.between(1, 200)};
  Cells at = farthest(mesh, way);
  Cells along{};
  std::size_t longest = 0;
  std::int64_t size = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t y = (axis + 1) % 3;
    const std::size_t z = (axis + 2) % 3;
    along[axis] = way[y] * other[z] - way[z] * other[y];
    size = std::max(size, std::abs(along[axis]));
    longest = std::abs(way[axis]) > std::abs(way[longest]) ? axis : longest;
  }
  at[longest] += way[longest] > 0 ? 1 : -1;
  const std::int64_t times = kFarthest / size;
  const auto point = [&](std::int64_t sign) {
    const auto part = [&](std::size_t i) {
      return static_cast<std::int32_t>(at[i] + sign * times * along[i]);
    };
    return Point{part(0), part(1), part(2)};
  };
  return {point(-1), point(1)};
}

enum class Aim { vertex, edge, beside };
constexpr const char* kAims[] = {"vertex", "edge", "beside"};

flashbvh::Segment any_ray(const Mesh& mesh, Aim aim, Random& random) {
  if (aim == Aim::beside) {
    return any_beside(mesh, random);
  }
  const auto& corner = mesh.triangles[random.below(mesh.triangle_count)].corner;
  const Cells first = vertex_of(mesh, corner[0]);
  const Cells second = vertex_of(mesh, corner[aim == Aim::edge ? 1 : 0]);
  return any_segment({first[0] + second[0], first[1] + second[1], first[2] + second[2]}, random);
}

/// Counts wrong answers: a ray misses its target, hits behind it, or hits a mesh that it passes.
void query_rays(const std::string& name_of_mesh, const Mesh& mesh) {
  const std::pair<const char*, std::unique_ptr<RayCaster>> libraries[] = {
      {"flashbvh", ray_caster_of_flashbvh(mesh)},
      {"opcode", ray_caster_of_opcode(mesh)},
      {"bullet", ray_caster_of_bullet(mesh)}};
  for (const Aim aim : {Aim::vertex, Aim::edge, Aim::beside}) {
    Random random(kSeed);
    std::size_t wrong[3] = {0, 0, 0};
    for (std::size_t i = 0; i < kQueries; ++i) {
      const flashbvh::Segment segment = any_ray(mesh, aim, random);
      for (std::size_t of = 0; of < 3; ++of) {
        const double share = libraries[of].second->nearest(segment);
        wrong[of] += aim == Aim::beside ? share < kNoHit : share > 0.5 + 1e-4;
      }
    }
    for (std::size_t of = 0; of < 3; ++of) {
      std::printf("known %s %s %s %zu %zu\n", kAims[static_cast<int>(aim)], name_of_mesh.c_str(),
                  libraries[of].first, kQueries, wrong[of]);
    }
  }
}

}  // namespace

void query_known_answers(const std::string& names, const Mesh& a, const Mesh& b) {
  query_touching(names, a, b);
  if (a.triangle_count == 12 && b.triangle_count == 12) {
    query_distances(names, a, b);
  }
  query_rays(names.substr(0, names.find('-')), a);
}

}  // namespace compare
