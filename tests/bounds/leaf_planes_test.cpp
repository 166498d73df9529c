// Leaf planes reject no pair of triangles that intersect: against brute force, where they have the
// least room.
#include "support/any_mesh.hpp"
#include "support/test.hpp"
#include "support/triangle_pairs.hpp"

using namespace flashbvh::detail;

namespace {

/// Turns some triangles into points or segments, or moves them into one of two planes.
void flatten(Random& random, bake::LatticeMesh& mesh, bool all_in_plane) {
  for (const auto& triangle : mesh.triangles) {
    Vertex* const corner[3] = {&mesh.vertices[triangle[0]], &mesh.vertices[triangle[1]],
                               &mesh.vertices[triangle[2]]};
    const std::uint32_t kind = random.below(5);
    for (Vertex* v : corner) {
      if (all_in_plane || kind == 0) {
        v->z = 0;
      } else if (kind == 1) {
        v->z = static_cast<std::int16_t>(v->x + v->y);
      }
    }
    if (kind == 2) {
      *corner[1] = *corner[2] = *corner[0];
    } else if (kind == 3) {
      *corner[random.below(2)] = *corner[2];
    }
  }
}

Vertex vertex(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto clamped = [](std::int64_t at) {
    return static_cast<std::int16_t>(std::clamp<std::int64_t>(at, -kMaxCoordinate, kMaxCoordinate));
  };
  return {clamped(x), clamped(y), clamped(z)};
}

void add_triangle(bake::LatticeMesh& mesh, const Vertex& p, const Vertex& q, const Vertex& r) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {p, q, r});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Adds a triangle on the largest lattice: long and thin, or long both ways, often near an axis.
void add_extreme_triangle(Random& random, bake::LatticeMesh& mesh) {
  const auto far = [&] {
    const std::int32_t at = random.between(14000, kMaxCoordinate);
    return random.below(2) == 0 ? at : -at;
  };
  const auto any = [&] { return random.between(-kMaxCoordinate, kMaxCoordinate); };
  std::int32_t p[3] = {any(), any(), any()};
  std::int32_t q[3] = {p[0] + random.between(-3, 3), p[1] + random.between(-3, 3), p[2]};
  const std::uint32_t axis = random.below(3);
  p[axis] = far();
  q[axis] = -p[axis];
  if (random.below(3) == 0) {
    q[(axis + 1) % 3] = far();
  }
  std::int32_t r[3] = {q[0], q[1], q[2]};
  if (random.below(2) == 0) {
    r[(axis + 2) % 3] = far();
  } else {
    r[random.below(3)] += random.below(2) == 0 ? random.between(1, 3) : -random.between(1, 3);
  }
  add_triangle(mesh, vertex(p[0], p[1], p[2]), vertex(q[0], q[1], q[2]), vertex(r[0], r[1], r[2]));
}

bake::LatticeMesh extreme_mesh(Random& random, std::uint32_t count) {
  bake::LatticeMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    add_extreme_triangle(random, mesh);
  }
  return mesh;
}

/// A rotation with entries as coarse as a pose accepts, so that its defect is large.
Rotation coarse_rotation(Random& random) {
  const Rotation fine = rotation_of(any_quaternion(random));
  for (const std::int32_t dropped : {0xFFFF, 0x7FFF, 0x3FFF}) {
    Rotation coarse = fine;
    for (auto& row : coarse.entry) {
      for (std::int32_t& entry : row) {
        entry &= ~dropped;
      }
    }
    if (Pose::rigid(coarse.entry, {0, 0, 0}).status() == Status::done) {
      return coarse;
    }
  }
  return fine;
}

/// A rotation that stretches or shrinks the diagonal (1, 1, 1) as far as a pose accepts.
Rotation stretched_rotation(Random& random) {
  Rotation rotation = rotation_of(any_quaternion(random));
  const std::int64_t by = random.below(2) == 0 ? 127 : -127;
  for (auto& row : rotation.entry) {
    const std::int64_t sum = std::int64_t{row[0]} + row[1] + row[2];
    for (std::int32_t& entry : row) {
      entry += static_cast<std::int32_t>(floor_divide(sum * by, 128 << 14));
    }
  }
  return rotation;
}

/// A triangle across this diagonal, at its end.
bake::LatticeMesh diagonal_mesh(Random& random) {
  const auto step = [&] { return random.between(100, 300); };
  const std::int32_t at = random.below(2) == 0 ? 16000 : -16000;
  const std::int32_t u = step();
  const std::int32_t v = step();
  bake::LatticeMesh mesh;
  add_triangle(mesh, vertex(at, at, at), vertex(at + u, at - u, at), vertex(at, at + v, at - v));
  return mesh;
}

/// A lattice point in or next to a triangle of a mesh: at a corner, on an edge, or inside.
Vertex point_of(Random& random, const bake::LatticeMesh& mesh, std::uint32_t triangle) {
  const auto& corner = mesh.triangles[triangle];
  const std::int32_t parts = random.below(3) == 0 ? 1 : 1000;
  const std::int32_t u = random.between(0, parts);
  const std::int32_t v = random.below(2) == 0 ? 0 : random.between(0, parts - u);
  const auto at = [&](std::int16_t Vertex::*axis) {
    const std::int32_t p = mesh.vertices[corner[0]].*axis;
    return p +
           ((mesh.vertices[corner[1]].*axis - p) * u + (mesh.vertices[corner[2]].*axis - p) * v) /
               parts;
  };
  return vertex(at(&Vertex::x), at(&Vertex::y), at(&Vertex::z));
}

/// A pose that places vertex `b` on `a`, or within a cell of it.
Pose touching_pose(Random& random, const Rotation& rotation, const Vertex& a, const Vertex& b) {
  const Pose turned = Pose::rigid(rotation.entry, {0, 0, 0});
  const std::int32_t origin[3] = {0, 0, 0};
  std::int32_t cells[3];
  std::int16_t fraction[3];
  for (int axis = 0; axis < 3; ++axis) {
    cells[axis] = a.*kVertexAxes[axis] - transformed_coordinate(origin, b, turned, axis) +
                  (random.below(3) == 0 ? random.between(-1, 1) : 0);
    fraction[axis] = static_cast<std::int16_t>(random.between(-32768, 32767));
  }
  return Pose::rigid(rotation.entry, cells, fraction);
}

/// A vertex of A, rounded to B's lattice.
Vertex seen_from_b(const Pose& pose, const Vertex& a) {
  const std::int64_t from[3] = {a.x - pose.translation(0), a.y - pose.translation(1),
                                a.z - pose.translation(2)};
  const auto along = [&](int axis) {
    return floor_divide(from[0] * pose.rotation(0, axis) + from[1] * pose.rotation(1, axis) +
                            from[2] * pose.rotation(2, axis) + kRotationOne / 2,
                        kRotationOne);
  };
  return vertex(along(0), along(1), along(2));
}

Vertex seen_from_a(const Pose& pose, const Vertex& b) {
  const Point at = transformed(bake::LatticeMesh(), b, pose);
  return vertex(at.x, at.y, at.z);
}

/// Adds a point, or a segment or triangle of a few cells.
void add_speck(Random& random, bake::LatticeMesh& mesh, const Vertex& at) {
  const auto near = [&] {
    const Point off = any_point(random, random.below(2) == 0 ? 1 : 2);
    return vertex(at.x + off.x, at.y + off.y, at.z + off.z);
  };
  const std::uint32_t kind = random.below(3);
  const Vertex p = kind == 0 ? at : near();
  const Vertex q = kind == 0 ? at : near();
  add_triangle(mesh, p, q, kind == 2 ? near() : q);
}

}  // namespace

TEST_CASE("one mesh may be both: its leaves are shapes on either side") {
  std::size_t pairs = 0;
  constexpr std::uint32_t tries = 250u;
  for_rounds(tries, 1, [&](Random& random, std::uint32_t round) {
    const std::int32_t size = round % 2 == 0 ? 25 : 8;
    const AnyMesh any = any_mesh(random, 20, 40, size);
    pairs += check_all(any, any, any_pose(random, 40));
  });
  CHECK(pairs > tries / 2);
}

TEST_CASE("triangles without area or in one plane are shapes, too") {
  std::size_t pairs = 0;
  constexpr std::uint32_t tries = 200u;
  for_rounds(tries, 2, [&](Random& random, std::uint32_t round) {
    bake::LatticeMesh meshes[2] = {random_mesh(random, 1 + random.below(24), 15, 12),
                                   random_mesh(random, 1 + random.below(24), 15, 12)};
    for (bake::LatticeMesh& mesh : meshes) {
      flatten(random, mesh, round % 4 == 0);
    }
    const AnyMesh a = any_mesh(random, meshes[0]);
    const AnyMesh b = any_mesh(random, meshes[1]);
    const Pose pose =
        round % 3 == 0 ? Pose::translated(random.between(-5, 5), 2, 0) : any_pose(random, 10);
    pairs += check_all(a, b, pose);
  });
  CHECK(pairs > tries / 2);
}

TEST_CASE("on the largest lattice, no slab of a leaf misses what lies in its triangle") {
  std::size_t pairs = 0;
  const auto tries = rounds(1200u, 6000u);
  for_rounds(tries, 3, [&](Random& random, std::uint32_t round) {
    const bool leaf_of_a = round % 2 == 0;
    const bool stretched = round % 8 == 1;
    const std::uint32_t count = stretched ? 1 : 1 + random.below(2);
    const bake::LatticeMesh leaf = stretched ? diagonal_mesh(random) : extreme_mesh(random, count);
    const Rotation rotation = stretched ? stretched_rotation(random) : coarse_rotation(random);
    const Vertex first = point_of(random, leaf, 0);
    const Vertex other = point_of(random, extreme_mesh(random, 1), 0);
    const Pose pose = leaf_of_a ? touching_pose(random, rotation, first, other)
                                : touching_pose(random, rotation, other, first);
    REQUIRE(pose.status() == Status::done);
    bake::LatticeMesh specks;
    for (std::uint32_t i = 0; i < 5; ++i) {
      const Vertex at = point_of(random, leaf, random.below(count));
      add_speck(random, specks, leaf_of_a ? seen_from_b(pose, at) : seen_from_a(pose, at));
    }
    const auto of_leaf = baked(bake::build_median(leaf, 2), leaf);
    const auto of_specks = baked(bake::build_median(specks, 1), specks);
    const Mesh a = leaf_of_a ? of_leaf.view() : of_specks.view();
    const Mesh b = leaf_of_a ? of_specks.view() : of_leaf.view();
    PairQuery query(a, b, pose);
    const Pairs found = sorted(run_to_end(query));
    REQUIRE(found == test::brute_force(leaf_of_a ? leaf : specks, leaf_of_a ? specks : leaf, pose));
    pairs += found.size();
  });
  CHECK(pairs > 2 * tries / 3);
}

TEST_CASE("on the largest lattice, thin triangles that just touch are found") {
  std::size_t pairs = 0;
  const auto tries = rounds(150u, 600u);
  for_rounds(tries, 4, [&](Random& random, std::uint32_t round) {
    const bake::LatticeMesh mesh_a = extreme_mesh(random, 2 + random.below(5));
    const bake::LatticeMesh mesh_b = extreme_mesh(random, 2 + random.below(5));
    const Vertex& corner = mesh_b.vertices[random.below(3)];
    const Vertex at = point_of(random, mesh_a, 0);
    const Pose pose = round % 5 == 0
                          ? Pose::translated(at.x - corner.x, at.y - corner.y, at.z - corner.z)
                          : touching_pose(random, coarse_rotation(random), at, corner);
    const AnyMesh a(bake::build_median(mesh_a, 1), mesh_a);
    const AnyMesh b(bake::build_median(mesh_b, 1), mesh_b);
    pairs += check_all(a, b, pose);
  });
  CHECK(pairs > tries / 2);
}
