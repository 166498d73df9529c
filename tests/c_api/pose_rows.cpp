// Poses from integers and floats, and in place.
#include "c_api/scene.hpp"
#include "flashbvh/float.hpp"
#include "support/rotations.hpp"

namespace flashbvh::test {
namespace {

/// Calls `make` twice in place: its output is its second argument, then its first one.
template <class Make>
bool in_place_agrees(Make make, const flashbvh_pose& p, const flashbvh_pose& q,
                     const Pose& wanted) {
  flashbvh_pose first = p;
  flashbvh_pose second = q;
  return same(make(&first, &q, &first), wanted.status()) && same(first, wanted) &&
         same(make(&p, &second, &second), wanted.status()) && same(second, wanted);
}

bool products_agree(Scene& s) {
  const Pose other = any_rigid_pose(s.random, 20);
  const flashbvh_pose c_other = c_pose_of(other);
  flashbvh_pose inverse = s.c_pose;
  return same(c_other, other) &&
         in_place_agrees(flashbvh_pose_composed, s.c_pose, c_other,
                         Pose::composed(s.pose, other)) &&
         in_place_agrees(flashbvh_pose_relative, s.c_pose, c_other,
                         Pose::relative(s.pose, other)) &&
         same(flashbvh_pose_inverse(&inverse, &inverse), s.pose.status()) &&
         same(inverse, s.pose.inverse());
}

bool translations_agree(Scene& s) {
  const std::int32_t x = s.random.between(-kMaxTranslation - 9, -kMaxTranslation + 9);
  const Pose wanted = Pose::translated(x, 2, -x - 9);
  flashbvh_pose made;
  return same(flashbvh_pose_translated(x, 2, -x - 9, &made), wanted.status()) && same(made, wanted);
}

/// Sometimes with a float that is not a number, or a scaled rotation.
bool floats_agree(Scene& s) {
  float rows[3][3];
  for (int i = 0; i < 9; ++i) {
    rows[i / 3][i % 3] = static_cast<float>(s.pose.rotation(i / 3, i % 3)) / kRotationOne;
  }
  rows[1][1] += s.random.below(4) == 0 ? 0.01f : 0;
  const float at[3] = {static_cast<float>(s.random.between(-9999, 9999)) / 7, -0.25f,
                       s.random.below(4) == 0 ? 1e30f : 3};
  const float scale = static_cast<float>(s.random.between(0, 1000)) / 3;
  const float q[4] = {0.5f, -0.5f, 0.5f, s.random.below(3) == 0 ? 0.6f : 0.5f};
  const Pose of_rows = pose_of(rows, at, scale);
  const Pose of_q = pose_of(UnitQuaternion{q[0], q[1], q[2], q[3]}, at, scale);
  flashbvh_pose made;
  return same(flashbvh_pose_of_matrix(rows[0], at, scale, &made), of_rows.status()) &&
         same(made, of_rows) &&
         same(flashbvh_pose_of_quaternion(q, at, scale, &made), of_q.status()) && same(made, of_q);
}

}  // namespace

std::vector<Row> pose_rows() {
  return {{"translations", translations_agree},
          {"products and inverses", products_agree},
          {"poses of floats", floats_agree}};
}

}  // namespace flashbvh::test
