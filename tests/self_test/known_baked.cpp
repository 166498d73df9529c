// The library's known meshes equal the tool's current bakes.
#include "known.robot.h"
#include "known_mesh.fbvh.h"
#include "robot/known_robot.hpp"
#include "self_test/known_mesh.hpp"
#include "support/test.hpp"

namespace {

template <std::size_t known, std::size_t baked>
bool are_same(const std::uint32_t (&u)[known], const std::uint32_t (&v)[baked]) {
  return std::equal(std::begin(u), std::end(u), std::begin(v), std::end(v));
}

}  // namespace

TEST_CASE("the words of the known mesh and of the known robot are what is baked of their sources") {
  CHECK(are_same(detail::kKnownMesh, known_mesh_image));
  CHECK(are_same(detail::kKnownRobot, known_robot_image));
}
