// Known-answer test of rays and of points inside a mesh.
#include "flashbvh/ray.hpp"
#include "flashbvh/self_test.hpp"
#include "flashbvh/solid.hpp"
#include "known_answers.hpp"

namespace flashbvh {
namespace detail {

/// Casts rays from outside into the mesh, and tests whether their ends are inside.
uint32_t known_rays_digest() {
  const Mesh mesh = known_mesh();
  AnswerDigest digest;
  for (int32_t i = 0; i < 16; ++i) {
    const Point to = {1700 - 230 * i, 60 * i - 500, 400 - 50 * i};
    const Segment ray = {{i % 2 == 0 ? 4000 : -4000, 900 - 130 * i, 250 * i - 2000}, to};
    const RayAnswer<uint16_t> answer = nearest_hit(mesh, ray);
    digest.add(static_cast<uint32_t>(answer.status), answer.yes ? 1 : 0);
    digest.add(answer.visits);
    if (answer.yes) {
      digest.add(answer.hit.triangle, static_cast<uint8_t>(answer.hit.side));
      digest.add(distance_along(ray, answer.hit.along));
    }
    const PointAnswer point = inside(mesh, to);
    digest.add(static_cast<uint32_t>(point.side), point.visits);
  }
  return digest.value();
}

}  // namespace detail

Status test_known_rays() {
  return detail::passed(detail::known_rays_digest(), 0x2311167Eu);
}

}  // namespace flashbvh
