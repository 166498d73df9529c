// The inner step of the rotated box test, in the form for this core:
//     rotate_and_compare(kept, box, other)   rotates `box` by kept.by, stores it and its source in
//                                            `kept`; 0 if it overlaps `other`
#pragma once

#include "flashbvh/detail/bounds/box_rotated.hpp"

#if defined(FLASHBVH_PORTABLE)
#include "portable/rotate_box.hpp"
#elif defined(FLASHBVH_ROTATE_SSE2)
#include "sse2/rotate_box.hpp"
#elif !defined(__thumb__) || __ARM_ARCH_PROFILE != 'M'
#include "plain/rotate_box.hpp"
#elif defined(__ARM_FEATURE_DSP)
#include "dsp/rotate_box.hpp"
#elif defined(__thumb2__)
#include "thumb2/rotate_box.hpp"
#else
#include "thumb1/rotate_box.hpp"
#endif
