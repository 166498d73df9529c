// Two small bodies and their motions: apart, grazing, sliding, resting, meeting.
#pragma once

#include <utility>

#include "flashbvh/first_contact.hpp"
#include "support/boxes.hpp"
#include "support/rotations.hpp"
#include "support/shapes.hpp"
#include "support/triangle_pairs.hpp"

namespace flashbvh::test {

struct Body {
  bake::LatticeMesh source;
  bake::BuildTree tree;
  Baked<Layout::post_indexed> baked;

  Body(Random& random, const bake::LatticeMesh& mesh)
      : source(mesh), tree(any_tree(random, mesh)), baked(test::baked(tree, mesh)) {}

  /// A random corner, in cells of the body's frame.
  Point any_corner(Random& random) const {
    const Vertex& v = random.one_of(source.vertices);
    return {v.x + source.origin[0], v.y + source.origin[1], v.z + source.origin[2]};
  }
};

inline bake::LatticeMesh mesh_of(const Triangle& t) {
  bake::LatticeMesh mesh;
  for (const Point& p : t.corner) {
    mesh.vertices.push_back(vertex_of(p));
  }
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Two random meshes of about `size` cells.
inline std::pair<bake::LatticeMesh, bake::LatticeMesh> any_meshes(Random& random, int32_t size) {
  const auto any = [&] {
    const uint32_t count = 1 + random.below(random.below(3) == 0 ? 8 : 3);
    return random_mesh(random, count, size * random.between(0, 2), size);
  };
  const auto flat = [&] {
    bake::LatticeMesh mesh = any();
    for (Vertex& v : mesh.vertices) {
      v.z = 0;
    }
    return mesh;
  };
  const auto box = [&] {
    bake::LatticeMesh mesh;
    add_box(mesh, any_point(random, size), {size, 1 + size / 2, 1}, false);
    return mesh;
  };
  const auto apart = [](const TransformedPair& pair) {
    return std::pair(mesh_of(pair.a), mesh_of(pair.b));
  };
  switch (random.below(size > 255 ? 3 : 8)) {
    case 3:
      return apart(coplanar_pair(random, size));
    case 4:
      return apart(touching_pair(random, size + 12));
    case 5:
      return {triangle_within(random, size).corner[0].x == 0 ? box() : flat(), box()};
    case 6:
      return {flat(), flat()};
    case 7:
      return apart({triangle_within(random, size), triangle_within(random, size)});
    default: {
      const bake::LatticeMesh mesh = any();
      return {mesh, random.below(8) == 0 ? mesh : any()};
    }
  }
}

struct MotionScene {
  int32_t size;
  Body a, b;

  static MotionScene any(Random& random) {
    const int32_t sizes[] = {1, 2, 3, 5, 24, 24, 255, random.between(1000, 14'000)};
    const int32_t size = random.one_of(sizes);
    auto meshes = any_meshes(random, size);
    for (bake::LatticeMesh* mesh : {&meshes.first, &meshes.second}) {
      for (std::int32_t& axis : mesh->origin) {
        const int32_t most = random.below(32) == 0 ? 200'000 : 3 * size;
        axis = random.below(2) == 0 ? 0 : random.between(-most, most);
      }
    }
    return {size, Body(random, meshes.first), Body(random, meshes.second)};
  }
};

/// A translation of B, which is not rotated, in cells.
struct Translation {
  Point from;
  Point way;

  BodyMotion motion() const {
    return BodyMotion::between(Pose::translated(from.x, from.y, from.z),
                               Pose::translated(from.x + way.x, from.y + way.y, from.z + way.z));
  }
};

/// A step of a translation: along an edge, along an axis, none, or any.
inline Point any_step(Random& random, const MotionScene& scene) {
  const Body& of = random.below(2) == 0 ? scene.a : scene.b;
  const Point corner = of.any_corner(random);
  const Point edge = sum(corner, scaled(-1, of.any_corner(random)));
  const Point step = any_point(random, scene.size);
  Point along = {0, 0, 0};
  along.*kPointAxes[random.below(3)] = step.x;
  const Point rest = random.below(4) == 0 ? Point{0, 0, 0} : step;
  const Point steps[] = {edge, edge, along, rest, step, step};
  return random.one_of(steps);
}

/// Two corners meet, or nearly so, after `after` of `count` steps: 0 to `count` + 1.
inline Translation any_translation(Random& random, const MotionScene& scene) {
  const Point step = any_step(random, scene);
  const int32_t count = random.between(1, 8);
  const int32_t after = random.between(0, count + 1);
  const int32_t beside[] = {0, 0, 1, 2, 3 * scene.size};
  const Point off = any_point(random, random.one_of(beside));
  const Point corner = sum(scene.a.any_corner(random), off);
  const Point at = sum(corner, scaled(-1, scene.b.any_corner(random)));
  return {sum(at, scaled(-after, step)), scaled(count, step)};
}

}  // namespace flashbvh::test
