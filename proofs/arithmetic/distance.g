# distances: dot products fit 64 bits, numerators are below 2^108, denominators below 2^72, and their product in 192
# code: include/flashbvh/detail/predicates/triangle_distance.hpp | constexpr int32_t kMaxApart = (1 << 17) - 1;
# code: src/predicates/triangle_distance.cpp | return Width::product(ff, re) - Width::product(ef, rf);
# Differences up to kMaxApart. A numerator is the square of r . (e x f), or a square length times an area.
ee = a * a + b * b + c * c;             # also for e.f, r.e, r.f
area = ee2 * ff - ef * ef;
shares = ee2 * re - ef * ef2;         # first(), second()
area64 = ee3 * ff3 - ef3 * rf3;         # differences below 2^14
nx = a * b2 - b * a2; ny = nx2 + 0; nz = nx3 + 0;
height = nx2 * a + nx3 * b + nx4 * c;
squared = height2 * height2;
cross = squared2 * below;               # the comparison of two fractions
limit = squared2 * steps;               # the comparison with a ShortFraction
limit2 = short * below;
{ |a| <= @kMaxApart@ /\ |b| <= @kMaxApart@ /\ |c| <= @kMaxApart@ /\ |a2| <= @kMaxApart@ /\ |b2| <= @kMaxApart@ /\
  ee2 in [0,@3 * kMaxApart**2@] /\ ff in [0,@3 * kMaxApart**2@] /\ |re| <= @3 * kMaxApart**2@ /\
  |ee3| <= @3 * 2**28@ /\ |ff3| <= @3 * 2**28@ /\ |ef3| <= @3 * 2**28@ /\ |rf3| <= @3 * 2**28@ /\ |ef| <= @3 * kMaxApart**2@ /\ |ef2| <= @3 * kMaxApart**2@ /\
  |nx2| <= @2 * kMaxApart**2@ /\ |nx3| <= @2 * kMaxApart**2@ /\ |nx4| <= @2 * kMaxApart**2@ /\
  |height2| <= @6 * kMaxApart**3@ /\ squared2 in [0,@2**108@] /\ below in [1,@2**72@] /\
  steps in [1,@proximity.hpp:kStepsSquared@] /\ short in [0,@proximity.hpp:kMostShort**2@]
  -> |ee| <= @3 * kMaxApart**2@ /\ |area| <= @2**72@ /\ |shares| <= @2**127 - 1@ /\ |area64| <= @INT64_MAX@ /\ |nx| <= @2 * kMaxApart**2@ /\
     |height| <= @6 * kMaxApart**3@ /\ |height| <= @INT64_MAX@ /\ squared in [0,@2**108@] /\
     cross in [0,@2**192 - 1@] /\ limit in [0,@2**127 - 1@] /\ limit2 in [0,@2**127 - 1@] }
