// The object layout on which the assembly forms of the rotated box test rely.
#pragma once

#include <stddef.h>

#include "flashbvh/detail/bounds/box_rotated.hpp"

/// Attributes of a function that assembly calls by name. The compiler must not drop or rename it,
/// and link-time optimisation must not hide it from its caller.
#if defined(__clang__)
#define FLASHBVH_CALLED_BY_NAME gnu::naked, gnu::used, gnu::visibility("hidden")
#else
#define FLASHBVH_CALLED_BY_NAME \
  gnu::naked, gnu::used, gnu::externally_visible, gnu::visibility("hidden")
#endif

namespace flashbvh::detail {

static_assert(offsetof(RotatedBox, bounds) == 0 && offsetof(RotatedBox, source) == 12 &&
              offsetof(RotatedBox, by.matrix) == 16 && offsetof(RotatedBox, by.starts) == 20 &&
              sizeof(RotatedBox) == 24 && sizeof(RotatedBoxTest) == 48);
static_assert(sizeof(SplitRow) == 12 && sizeof(BoxTestStart) == 8 && kSplitBits == 14);

}  // namespace flashbvh::detail
