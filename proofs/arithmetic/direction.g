# slabs' directions: cross products and squares of edges within 32,766 fit 32 bits
# code: include/flashbvh/detail/bounds/slab.hpp | int32_t x = u.y() * v.z - u.z * v.y();
p1 = uy * vz; p2 = uz * vy; x = p1 - p2;
square = uy * uy + uz * uz + vy * vy;
{ |uy| <= @2 * kMaxCoordinate@ /\ |uz| <= @2 * kMaxCoordinate@ /\
  |vy| <= @2 * kMaxCoordinate@ /\ |vz| <= @2 * kMaxCoordinate@
  -> |p1| <= @INT32_MAX@ /\ |x| <= @INT32_MAX@ /\ square in [0,@UINT32_MAX@] }
