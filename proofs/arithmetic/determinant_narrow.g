# narrow triangles: cofactors fit 32 bits, and determinants 64 with a difference of any pair of corners
# code: src/predicates/triangle.cpp | using Narrow = PlaneNormal;
# code: include/flashbvh/detail/bounds/transform.hpp | normal = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
p1 = uy * vz; p2 = uz * vy; nx = p1 - p2;
q1 = nx * wx; q2 = ny * wy; q3 = nz * wz;
s1 = q1 + q2; det = s1 + q3;
{ |uy| <= @triangle.cpp:kMaxNarrow@ /\ |uz| <= @triangle.cpp:kMaxNarrow@ /\
  |vy| <= @triangle.cpp:kMaxNarrow@ /\ |vz| <= @triangle.cpp:kMaxNarrow@ /\
  |ny| <= @INT32_MAX@ /\ |nz| <= @INT32_MAX@ /\
  |wx| <= @kMaxDifference@ /\ |wy| <= @kMaxDifference@ /\ |wz| <= @kMaxDifference@
  -> |p1| <= @INT32_MAX@ /\ |p2| <= @INT32_MAX@ /\ |nx| <= @INT32_MAX@ /\
     |s1| <= @INT64_MAX@ /\ |det| <= @INT64_MAX@ }
