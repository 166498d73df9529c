// Queries with answers known by construction: meshes that touch in a point or are within a cell of
// it, distances of boxes, and rays through vertices and edges of a mesh. All numbers are integers
// below 2^24, or their quotients by 1,024: binary32 holds each.
#include <Eigen/Geometry>
#include <algorithm>
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

using Cells = Eigen::Matrix<std::int64_t, 3, 1>;
using Turn = Eigen::Matrix<std::int64_t, 3, 3>;

Cells vertex_of(const Mesh& mesh, std::uint32_t i) {
  const flashbvh::Vertex& v = mesh.vertices[i];
  return {mesh.origin[0] + v.x, mesh.origin[1] + v.y, mesh.origin[2] + v.z};
}

/// The farthest vertex along `way`.
Cells farthest(const Mesh& mesh, const Cells& way) {
  Cells best = vertex_of(mesh, 0);
  for (std::uint32_t i = 1; i < mesh.vertex_count; ++i) {
    const Cells vertex = vertex_of(mesh, i);
    best = vertex.dot(way) > best.dot(way) ? vertex : best;
  }
  return best;
}

Point point_of(const Cells& cells) {
  return {static_cast<std::int32_t>(cells[0]), static_cast<std::int32_t>(cells[1]),
          static_cast<std::int32_t>(cells[2])};
}

std::size_t longest_axis(const Cells& way) {
  std::size_t axis = 0;
  way.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// One of the 24 rotations of a cube, so that no vertex is rounded.
Turn any_turn(Random& random) {
  const auto quarter = [&random] {
    flashbvh::test::Quaternion q{};
    std::int32_t* const part[] = {&q.x, &q.y, &q.z};
    q.w = random.between(-1, 1);
    *part[random.below(3)] = q.w == 0 ? 1 : random.between(-1, 1);
    const flashbvh::test::Rotation rotation = flashbvh::test::rotation_of(q);
    const Eigen::Map<const Eigen::Matrix<std::int32_t, 3, 3, Eigen::RowMajor>> entries(
        rotation.entry[0]);
    return Turn(entries.cast<std::int64_t>() / flashbvh::kRotationOne);
  };
  const Turn first = quarter();
  return first * quarter();
}

Placed placed(const Turn& turn, const Cells& at) {
  Placed placed{{}, {}, flashbvh::Pose::translated(0, 0, 0)};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      placed.rotation.entry[row][column] =
          static_cast<std::int32_t>(turn(row, column) * flashbvh::kRotationOne);
    }
    placed.cells[row] = static_cast<std::int32_t>(at[row]);
  }
  placed.pose = flashbvh::Pose::rigid(placed.rotation.entry, placed.cells);
  return placed;
}

Cells any_way(Random& random, bool along_axis) {
  Cells way = Cells::Zero();
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
  const Turn turn = any_turn(random);
  const Cells way = any_way(random, random.below(2) == 0);
  const Cells back = -(turn.transpose() * way);  // in B's frame
  Cells at = farthest(a, way) - turn * farthest(b, back);
  const std::size_t longest = longest_axis(way);
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
  for (int axis = 0; axis < 3; ++axis) {
    const Cells way = Cells::Unit(axis);
    const Cells back = -way;
    const auto above = farthest(b, back)[axis] + at[axis] - farthest(a, way)[axis];
    const auto below = farthest(a, back)[axis] - farthest(b, way)[axis] - at[axis];
    const auto gap = static_cast<double>(std::max({std::int64_t{0}, above, below}));
    square += gap * gap;
  }
  return std::sqrt(square);
}

void query_distances(const std::string& names, const Mesh& a, const Mesh& b) {
  Random random(kSeed);
  std::vector<Placed> poses;
  std::vector<double> lengths;
  while (poses.size() < kQueries) {
    const Cells at = {random.between(-4000, 4000), random.between(-4000, 4000),
                      random.between(-4000, 4000)};
    const double length = distance_of_boxes(a, b, at);
    if (length > 0) {
      poses.push_back(placed(Turn::Identity(), at));
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
  return {point_of(from), point_of(twice - from)};
}

/// A segment in a plane at most a cell beyond the farthest vertex along `way`: it hits nothing.
flashbvh::Segment any_beside(const Mesh& mesh, Random& random) {
  const Cells way = any_way(random, /*along_axis=*/false);
  const Cells other = {random.between(-200, 200), random.between(-200, 200),
                       random.between(1, 200)};
  Cells at = farthest(mesh, way);
  const std::size_t longest = longest_axis(way);
  at[longest] += way[longest] > 0 ? 1 : -1;
  Cells along = way.cross(other);
  along *= kFarthest / std::max<std::int64_t>(1, along.cwiseAbs().maxCoeff());
  return {point_of(at - along), point_of(at + along)};
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
  return any_segment(first + second, random);
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
