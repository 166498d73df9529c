// Rays aimed at edges and corners of a closed mesh with winding numbers 0 and 1, where float ray
// casters lose rays.
#pragma once

#include <cstdint>

#include "flashbvh/ray.hpp"
#include "flashbvh/solid.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

class AimedRays {
 public:
  explicit AimedRays(const Mesh& mesh) : mesh_(mesh) {}

  /// Casts a ray exactly through a corner or the middle of an edge. It must hit there or before,
  /// and leave as often as it enters, but for the side of its ends.
  bool is_right(Random& random) const {
    const auto& corner = mesh_.triangles[random.below(mesh_.triangle_count)].corner;
    const Vertex& u = mesh_.vertices[corner[0]];
    const Vertex& v = mesh_.vertices[corner[random.below(3)]];
    const auto reach = random.below(4) == 0 ? kMaxRayCoordinate - 2 * kMaxCoordinate : 20'000;
    const auto at = [&] { return random.between(-reach, reach); };
    const Point from = {at(), at(), at()};
    const Point aimed = {u.x + v.x, u.y + v.y, u.z + v.z};  // doubled
    const Point to = {aimed.x - from.x, aimed.y - from.y, aimed.z - from.z};
    const Segment segment = {placed(from), placed(to)};
    const auto hit = nearest_hit(mesh_, segment);
    const auto back = nearest_hit(mesh_, {segment.to, segment.from});
    return is_hit_by_half(hit) && is_hit_by_half(back) && is_crossed_rightly(segment);
  }

 private:
  Point placed(const Point& p) const {
    return {p.x + mesh_.origin[0], p.y + mesh_.origin[1], p.z + mesh_.origin[2]};
  }
  static bool is_hit_by_half(const RayAnswer<std::uint16_t>& answer) {
    return answer.status == Status::done && answer.yes &&
           2 * answer.hit.along.above <= answer.hit.along.below;
  }
  bool is_crossed_rightly(const Segment& segment) const {
    const PointSide from = inside(mesh_, segment.from).side;
    const PointSide to = inside(mesh_, segment.to).side;
    const CrossingCount crossings = signed_crossings(mesh_, segment);
    if (from == PointSide::on_surface || to == PointSide::on_surface) {
      return crossings.outwards >= -1 && crossings.outwards <= 1;
    }
    const auto winding = [](PointSide side) { return side == PointSide::inside ? 1 : 0; };
    return crossings.outwards == winding(from) - winding(to);
  }

  const Mesh mesh_;
};

}  // namespace flashbvh::test
