# far distances: the same widths hold of two meshes' triangles up to kMaxFarApart apart, and of limits up to kMost
# code: include/flashbvh/detail/bounds/rotated_transform.hpp | constexpr int32_t kMaxFarOffset = 1 << 20;
# code: include/flashbvh/detail/predicates/triangle_distance.hpp | constexpr int32_t kMaxFarApart = (1 << 20) + (1 << 16);
# code: src/predicates/support_planes.cpp | return {length * way.x - along * edge.x,
# Differences up to kMaxFarApart; the offset leaves 2^16 of it: a lattice's corner is sqrt(3) kMaxCoordinate, 28,377,
# from its middle, and kMaxCoordinate along an axis. An edge is at most 2 sqrt(3) kMaxCoordinate long, and rounding adds
# sqrt(3): 56,760. e.e, e.f and the components of e x f are at most its square.
reach = 28377 + @kMaxCoordinate@;
re = a * x + b * y + c * z;             # r.e
rr = a * a + b * b + c * c;
area = ee * ff - ef * ef;
shares = ee * re2 - ef * rf2;           # first(), second()
height = nx * a + ny * b + nz * c;
squared = height2 * height2;
beside = rr2 * ee - re2 * re2;
cross = squared2 * below;               # the comparison of two fractions
limit = squared2 * steps;               # the comparison with a ShortFraction
limit2 = short * below;
line = ee * a - re2 * x;                # from_line(): a component is scaled to 54 bits
high = h1 * a + h2 * b + h3 * c;        # along the high parts of a normal of ties
low = l1 * a + l2 * b + l3 * c;
{ |a| <= @kMaxFarApart@ /\ |b| <= @kMaxFarApart@ /\ |c| <= @kMaxFarApart@ /\
  |x| <= 56760 /\ |y| <= 56760 /\ |z| <= 56760 /\
  ee in [0,@56760**2@] /\ ff in [0,@56760**2@] /\ |ef| <= @56760**2@ /\
  |re2| <= @3 * 56760 * kMaxFarApart@ /\ |rf2| <= @3 * 56760 * kMaxFarApart@ /\ rr2 in [0,@3 * kMaxFarApart**2@] /\
  |nx| <= @56760**2@ /\ |ny| <= @56760**2@ /\ |nz| <= @56760**2@ /\ |height2| <= @3 * 56760**2 * kMaxFarApart@ /\
  squared2 in [0,@2**108@] /\ below in [1,@2**64@] /\
  steps in [1,@proximity.hpp:kStepsSquared@] /\ short in [0,@proximity.hpp:kMost**2@] /\
  |h1| <= @2**28@ /\ |h2| <= @2**28@ /\ |h3| <= @2**28@ /\ l1 in [0,@2**26@] /\ l2 in [0,@2**26@] /\ l3 in [0,@2**26@]
  -> reach in [0,@kMaxFarApart - kMaxFarOffset@] /\
     |re| <= @3 * 56760 * kMaxFarApart@ /\ rr in [0,@3 * kMaxFarApart**2@] /\ |area| <= @2**64@ /\
     |shares| <= @2**127 - 1@ /\ |height| <= @3 * 56760**2 * kMaxFarApart@ /\ |height| <= @INT64_MAX@ /\
     squared in [0,@2**108@] /\ |beside| <= @2**108@ /\ cross in [0,@2**192 - 1@] /\ limit in [0,@2**127 - 1@] /\
     limit2 in [0,@2**127 - 1@] /\ |line| <= @2**54@ /\ |high| <= @INT64_MAX@ /\ |low| <= @INT64_MAX@ }
