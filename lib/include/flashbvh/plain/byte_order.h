/* Refuses big-endian cores at compile time: images lie in flash as they were baked, little-endian,
   and packed coordinates rely on where the halves of a word are. C as well as C++. */
#ifndef FLASHBVH_PLAIN_BYTE_ORDER_H
#define FLASHBVH_PLAIN_BYTE_ORDER_H

#if (defined(__BYTE_ORDER__) && __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__) || \
    defined(__ARM_BIG_ENDIAN) || defined(__BIG_ENDIAN__)
#error "flashbvh images are little-endian: big-endian cores are not supported"
#endif

#endif
