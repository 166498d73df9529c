# differences up to kMaxDifference: every product and partial sum of a determinant fits 64 bits
# code: src/predicates/orientation.hpp | return {wide.y * v.z - wide.z * v.y, wide.z * v.x - wide.x * v.z, wide.x * v.y - wide.y * v.x};
# code: src/predicates/orientation.hpp | return dot(cross<Cofactors>(difference(s, r), difference(q, p)), difference(r, p));
# code: src/predicates/orientation.hpp | return static_cast<int64_t>(q.*u - p.*u) * (r.*v - p.*v) -
p1 = uy * vz; p2 = uz * vy; nx = p1 - p2;
p3 = uz * vx; p4 = ux * vz; ny = p3 - p4;
p5 = ux * vy; p6 = uy * vx; nz = p5 - p6;
q1 = nx * wx; q2 = ny * wy; q3 = nz * wz;
s1 = q1 + q2; det = s1 + q3;
{ |ux| <= @kMaxDifference@ /\ |uy| <= @kMaxDifference@ /\ |uz| <= @kMaxDifference@ /\
  |vx| <= @kMaxDifference@ /\ |vy| <= @kMaxDifference@ /\ |vz| <= @kMaxDifference@ /\
  |wx| <= @kMaxDifference@ /\ |wy| <= @kMaxDifference@ /\ |wz| <= @kMaxDifference@
  -> |det| <= @INT64_MAX@ /\ |s1| <= @INT64_MAX@ /\
     |q1| <= @INT64_MAX@ /\ |q2| <= @INT64_MAX@ /\ |q3| <= @INT64_MAX@ /\
     |det| <= @6 * 2**60@ /\  # the bound that triangle.hpp states
     |nx| <= @INT64_MAX@ /\ |ny| <= @INT64_MAX@ /\ |nz| <= @INT64_MAX@ }
