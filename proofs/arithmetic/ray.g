# rays: turns about edges are below 2^57, shares' terms below 2^53
# code: src/predicates/segment_hit.cpp | return dot(cross<WideVector>(difference(u, from), difference(v, u)), way);
# code: src/predicates/segment_hit.cpp | const int64_t slope = dot(normal, way);
# From `from` to a corner: kMaxRayCoordinate + 2^15; way: twice a ray's end; edges: below 2^15.
cx = p * e - p2 * e2;
turn = nx * w + ny * w2 + nz * w3;
normal = e * e2 - e3 * e4;
slope = mx * w + my * w2 + mz * w3;
{ |p| <= @kMaxRayCoordinate + kMaxCoordinate@ /\ |p2| <= @kMaxRayCoordinate + kMaxCoordinate@ /\
  |e| <= @2 * kMaxCoordinate@ /\ |e2| <= @2 * kMaxCoordinate@ /\ |e3| <= @2 * kMaxCoordinate@ /\ |e4| <= @2 * kMaxCoordinate@ /\
  |w| <= @2 * kMaxRayCoordinate@ /\ |w2| <= @2 * kMaxRayCoordinate@ /\ |w3| <= @2 * kMaxRayCoordinate@ /\
  |nx| <= @4 * kMaxCoordinate * (kMaxRayCoordinate + kMaxCoordinate)@ /\
  |ny| <= @4 * kMaxCoordinate * (kMaxRayCoordinate + kMaxCoordinate)@ /\
  |nz| <= @4 * kMaxCoordinate * (kMaxRayCoordinate + kMaxCoordinate)@ /\
  |mx| <= @8 * kMaxCoordinate**2@ /\ |my| <= @8 * kMaxCoordinate**2@ /\ |mz| <= @8 * kMaxCoordinate**2@
  -> |cx| <= @4 * kMaxCoordinate * (kMaxRayCoordinate + kMaxCoordinate)@ /\ |turn| <= @2**57@ /\
     |normal| <= @8 * kMaxCoordinate**2@ /\ |slope| <= @2**53@ }
