# slabs: a box's or a corner's sums, biases, extents, offsets and margins together stay in 32 bits; of a far B all boxes touch
#
# A direction's magnitudes add up to at most 3 * 2^kDirectionBits, rotated 18 more (Slabs.v). `extent`: either end of a
# slab: a direction's sum times the largest coordinate, or a baked one (baked_slabs_fit of Exact.v), which is larger.
# `offset`: along an axis, at most kMaxOffset rotated, and 2^15 translated, for pairs whose boxes overlap. A far B's
# offset is rounded to at most a cell before it is translated; its `least` is below all sums of boxes.
# code: include/flashbvh/detail/bounds/transform.hpp | return slab_margin_ * kMarginUnit + static_cast<int32_t>(placing_) / 2 * kFarMargin;
# code: include/flashbvh/detail/bounds/slab.hpp | const int32_t bias = row_.sum() * kBoundBias;
# code: include/flashbvh/detail/bounds/slab.hpp | least_upper_ = bias + along.least + offset - margin;
# code: include/flashbvh/detail/bounds/slab.hpp | least_lower_ = bias - along.most - offset - margin;
# code: include/flashbvh/detail/bounds/slab.hpp | const int32_t least = least_upper_ - bias;
# code: include/flashbvh/detail/bounds/slab.hpp | const int32_t least_negated = least_lower_ - bias;
bias = sum * @kBoundBias@;
along = sum * place;          # of one vertex
shift = sum * offset;
s1 = bias + extent; s2 = s1 + shift; least = s2 - margin;
far = bias + extent + sum * near - margin - @transform.hpp:kFarMargin@;
unbiased = (extent + shift) - margin;   # for a corner: least without the bias; its own place is an `along`
box = sum * bound;            # add_products(): at least 0
{ sum in [0,@3 * 2**kDirectionBits + 18@] /\ |place| <= @kMaxCoordinate@ /\
  |extent| <= @tree_check.cpp:most * 2**kSlabUnitBits@ /\ |offset| <= @kMaxOffset@ /\ |near| <= 1 /\
  margin in [0,@65535 * transform.hpp:kMarginUnit@] /\ bound in [0,32767]
  -> |s1| <= @INT32_MAX@ /\ |s2| <= @INT32_MAX@ /\ |least| <= @INT32_MAX@ /\ far in [@INT32_MIN@,-1] /\
     |unbiased| <= @INT32_MAX@ /\ |along| <= @tree_check.cpp:most * 2**kSlabUnitBits@ /\
     |bias| <= @INT32_MAX@ /\ |shift| <= @INT32_MAX@ /\ box in [0,@INT32_MAX@] }
