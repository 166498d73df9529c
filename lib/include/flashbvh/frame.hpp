// A body's placement: a rotation in fixed point and a translation in 1/2,048 cell.
#ifndef FLASHBVH_FRAME_HPP
#define FLASHBVH_FRAME_HPP

#include <stdint.h>

#include "flashbvh/plain/points.h"
#include "flashbvh/pose.hpp"

namespace flashbvh {

/// Fraction bits of a frame's translation: 2,048 units are one cell.
constexpr int kFrameBits = 11;
constexpr int32_t kFrameCell = 1 << kFrameBits;

/// Largest magnitude of a frame's translation along each axis, in 1/2,048 cell: 2^19 cells. The
/// difference of two translations then fits 32 bits.
constexpr int32_t kMaxFrameTranslation = 1 << 30;

/// A full turn as an angle.
constexpr int32_t kFullTurn = 1 << 28;

using Frame = flashbvh_frame;

constexpr Frame kIdentityFrame = {
    {{kRotationOne, 0, 0}, {0, kRotationOne, 0}, {0, 0, kRotationOne}}, {0, 0, 0}};

}  // namespace flashbvh

#endif
