/* Refuses big-endian cores at compile time: images in flash are little-endian, and packed
 * coordinates rely on the order of a word's halves. For C and C++. */
#pragma once

#include "flashbvh/plain/language.h"

#if (defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) || \
    defined(__ARM_BIG_ENDIAN) || defined(__BIG_ENDIAN__)
#error "flashbvh images are little-endian: big-endian cores are not supported"
#endif
